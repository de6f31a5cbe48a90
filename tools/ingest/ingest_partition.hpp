#pragma once

#include "agents/city/city.hpp"
#include "tools/ingest/zones.hpp"

#include <string>
#include <vector>

namespace evbal {

/// Regions made of zones.
struct Partition {
  std::vector<Region> regions;  ///< from north to south; centroids are centres of area
  std::vector<Zone> zones;      ///< as read, with borders shared
  std::vector<int> region_of;   ///< by zone
  std::string report;           ///< what was read and what came of it; one item a line
};

/// Merges the zones of a file (read_zones) into connected, compact regions of about equal weight; with as many regions
/// as zones each becomes one. Borders that run along each other within 10 m become one. Throws Error{bad_input}.
Partition ingest_partition(const std::filesystem::path& zones, const ZoneFields& fields, int regions);

/// `zone,region`: for each zone its name and its region's, in the order of the file.
std::string zones_csv(const Partition& partition);

}  // namespace evbal

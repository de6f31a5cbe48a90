#pragma once

#include "agents/world/city.hpp"
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

/// read_zones, with borders that run along each other within 10 m made one.
ZoneFile read_bordering_zones(const std::filesystem::path& file, const ZoneFields& fields);

/// Merges such zones into connected, compact regions of about equal weight; with as many regions as zones each becomes
/// one. Throws Error{bad_input} with the file's report if there are fewer zones.
Partition partition_zones(ZoneFile file, int regions);

/// `zone,region`: for each zone its name and its region's, in the order of the file.
std::string zones_csv(const Partition& partition);

}  // namespace evbal

#pragma once

#include "tools/ingest/notes.hpp"
#include "tools/ingest/zones.hpp"

#include <vector>

namespace evbal {

/// What the first reading of the trips tells about the zones.
struct ZoneWeights {
  std::vector<double> pickups;  ///< by zone, on training days
  std::vector<double> ends;     ///< pick-ups and drop-offs by zone, on all days
  LatLon mean_pickup;           ///< of all pick-ups, around which zones are within reach
};

/// Zones merged into regions.
struct MergedZones {
  std::vector<int> region_of;      ///< by zone, -1 where it belongs to none
  std::vector<std::string> names;  ///< by region
  std::string left_out;            ///< which zones belong to none, with their trips; one item a line
};

/// Regions from north to south, then those apart. Zones count that lie within reach. Islands, which share no edge
/// with the others, are joined to the nearest, the busiest first; the last that have less than a hundredth of the
/// trip ends together are left out. Throws Error{bad_input} if that leaves too few zones, or if a place apart lies in
/// none.
MergedZones merge_zones(const std::vector<Zone>& zones, const ZoneWeights& weights, const CityNotes& notes,
                        int regions);

/// Merges all zones by Zone::weight, those on islands with the nearest. Regions from north to south. Throws
/// Error{bad_input} if there are fewer zones than regions.
MergedZones merge_all_zones(const std::vector<Zone>& zones, int regions);

}  // namespace evbal

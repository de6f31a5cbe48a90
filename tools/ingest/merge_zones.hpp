#pragma once

#include "tools/ingest/notes.hpp"
#include "tools/ingest/zones.hpp"

#include <vector>

namespace evbal {

/// What the first reading of the trips tells about the zones.
struct ZoneWeights {
  std::vector<double> pickups;  ///< by zone
  LatLon mean_pickup;           ///< of all pick-ups, around which zones are within reach
};

/// Zones merged into regions.
struct MergedZones {
  std::vector<int> region_of;      ///< by zone, -1 where it belongs to none
  std::vector<std::string> names;  ///< by region
};

/// Regions from north to south, then those apart. Zones count that lie within reach and are connected to the busiest
/// one. Throws Error{bad_input} if that leaves too few zones, or if a place apart lies in none.
MergedZones merge_zones(const std::vector<Zone>& zones, const ZoneWeights& weights, const CityNotes& notes,
                        int regions);

/// Merges all zones by Zone::weight, those on islands with the nearest. Regions from north to south. Throws
/// Error{bad_input} if there are fewer zones than regions.
MergedZones merge_all_zones(const std::vector<Zone>& zones, int regions);

}  // namespace evbal

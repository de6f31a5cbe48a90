#pragma once

#include "agents/world/geometry.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace evbal {

/// A city's regions on a plane.
struct CityMap {
  std::vector<std::string> names;                              ///< of the regions
  std::vector<std::vector<std::vector<LocalPoint>>> outlines;  ///< of each region its rings
};

/// Seen from the mean of the regions' centroids.
CityMap city_map(const std::vector<Region>& regions);

/// As pages read it: outlines as x, y, x, y, ... in whole tens of metres, y to the south.
nlohmann::ordered_json map_json(const CityMap& map);

}  // namespace evbal

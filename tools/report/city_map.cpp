#include "tools/report/city_map.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace evbal {

CityMap city_map(const std::vector<Region>& regions) {
  LatLon middle;
  for (const Region& region : regions) {
    middle.lat += region.centroid.lat / static_cast<double>(regions.size());
    middle.lon += region.centroid.lon / static_cast<double>(regions.size());
  }
  const LocalFrame frame(middle);
  CityMap map;
  for (const Region& region : regions) {
    map.names.push_back(region.name);
    auto& rings = map.outlines.emplace_back();
    for (const auto& ring : region.outline) {
      auto& points = rings.emplace_back();
      std::transform(ring.begin(), ring.end(), std::back_inserter(points),
                     [&frame](LatLon point) { return frame.local(point); });
    }
  }
  return map;
}

nlohmann::ordered_json map_json(const CityMap& map) {
  const auto tens = [](double metres) { return static_cast<int>(std::lround(metres / 10.0)); };
  nlohmann::ordered_json outlines = nlohmann::ordered_json::array();
  for (const auto& region : map.outlines) {
    nlohmann::ordered_json rings = nlohmann::ordered_json::array();
    for (const auto& ring : region) {
      nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
      for (const LocalPoint& point : ring) {
        numbers.push_back(tens(point.east));
        numbers.push_back(tens(-point.north));
      }
      rings.push_back(numbers);
    }
    outlines.push_back(rings);
  }
  return {{"names", map.names}, {"outlines", outlines}};
}

}  // namespace evbal

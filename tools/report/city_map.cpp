#include "tools/report/city_map.hpp"

#include <algorithm>

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

}  // namespace evbal

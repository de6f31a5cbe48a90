#include "tools/ingest/zone_places.hpp"

#include "common/random.hpp"

#include <algorithm>

namespace evbal {
namespace {

constexpr int kMostTries = 1000;  // a zone that fills less than a hundredth of its box is a sliver

/// Whether a corner lies within the rings (even-odd rule).
bool within(const Zone& zone, Corner at) {
  bool inside = false;
  for (const auto& ring : zone.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Corner& a = ring[i];
      const Corner& b = ring[(i + 1) % ring.size()];
      if ((a.lat > at.lat) != (b.lat > at.lat)) {
        const double crossing = a.lon + static_cast<double>(b.lon - a.lon) * (at.lat - a.lat) / (b.lat - a.lat);
        inside = inside != (at.lon < crossing);
      }
    }
  }
  return inside;
}

}  // namespace

ZonePlaces::ZonePlaces(const std::vector<Zone>& zones) {
  for (const Zone& zone : zones) {
    const Zone*& known = zones_.emplace(zone.name, &zone).first->second;
    known = zone.area_m2 > known->area_m2 ? &zone : known;
  }
}

std::optional<LatLon> ZonePlaces::place(std::string_view name, std::uint64_t draw) const {
  const auto found = zones_.find(name);
  if (found == zones_.end()) {
    return std::nullopt;
  }
  const Zone& zone = *found->second;
  Corner low = zone.rings.front().front();
  Corner high = low;
  for (const auto& ring : zone.rings) {
    for (const Corner& corner : ring) {
      low = {std::min(low.lat, corner.lat), std::min(low.lon, corner.lon)};
      high = {std::max(high.lat, corner.lat), std::max(high.lon, corner.lon)};
    }
  }
  RandomStream random(0, Purpose::trip_end, {.index = draw});
  for (int tries = 0; tries < kMostTries; ++tries) {
    const Corner corner{static_cast<int>(random.uniform(low.lat, high.lat)),
                        static_cast<int>(random.uniform(low.lon, high.lon))};
    if (within(zone, corner)) {
      return point_of(corner);
    }
  }
  return zone.centre;
}

}  // namespace evbal

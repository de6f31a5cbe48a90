#include "tools/ingest/zone_places.hpp"

#include "common/random.hpp"
#include "tools/ingest/zone_ids.hpp"

#include <algorithm>

namespace evbal {
namespace {

constexpr int kMostTries = 1000;  // a zone that fills less than a hundredth of its box is a sliver

/// How often a ring goes around a corner, counter-clockwise.
int turns_around(const std::vector<Corner>& ring, Corner at) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner& a = ring[i];
    const Corner& b = ring[(i + 1) % ring.size()];
    if ((a.lat > at.lat) != (b.lat > at.lat)) {
      const double crossing = a.lon + static_cast<double>(b.lon - a.lon) * (at.lat - a.lat) / (b.lat - a.lat);
      turns += at.lon < crossing ? (b.lat > a.lat ? 1 : -1) : 0;
    }
  }
  return turns;
}

/// Whether a corner lies in the zone and not in a hole; where its polygons overlap, too.
bool within(const Zone& zone, Corner at) {
  int turns = 0;
  for (const auto& ring : zone.rings) {
    turns += turns_around(ring, at);
  }
  return turns != 0;
}

/// One of the outer rings, by their areas.
const std::vector<Corner>& drawn_ring(const Zone& zone, RandomStream& random) {
  std::vector<const std::vector<Corner>*> outer;
  std::vector<double> up_to;  // sums of areas
  for (const auto& ring : zone.rings) {
    if (signed_area(ring) > 0.0) {
      outer.push_back(&ring);
      up_to.push_back(signed_area(ring) + (up_to.empty() ? 0.0 : up_to.back()));
    }
  }
  if (outer.size() < 2) {
    return outer.empty() ? zone.rings.front() : *outer.front();
  }
  const double drawn = random.uniform(0.0, up_to.back());
  const auto found = std::upper_bound(up_to.begin(), std::prev(up_to.end()), drawn);
  return *outer[static_cast<std::size_t>(found - up_to.begin())];
}

}  // namespace

ZonePlaces::ZonePlaces(const std::vector<Zone>& zones, char decimal) : decimal_(decimal) {
  for (const Zone& zone : zones) {
    zones_.emplace(zone.name, &zone);
    if (const auto number = whole_number(zone.name)) {
      const auto [known, is_new] = numbers_.emplace(*number, &zone);
      known->second = is_new ? &zone : nullptr;
    }
  }
}

const Zone* ZonePlaces::zone_of(std::string_view name) const {
  const auto exact = zones_.find(name);
  if (exact != zones_.end()) {
    return exact->second;
  }
  const auto number = whole_number(name, decimal_);
  const auto found = number ? numbers_.find(*number) : numbers_.end();
  return found == numbers_.end() ? nullptr : found->second;
}

std::optional<LatLon> ZonePlaces::place(std::string_view name, std::uint64_t draw) const {
  const Zone* zone = zone_of(name);
  if (zone == nullptr) {
    return std::nullopt;
  }
  RandomStream random(0, Purpose::trip_end, {.index = draw});
  const auto& ring = drawn_ring(*zone, random);
  Corner low = ring.front();
  Corner high = low;
  for (const Corner& corner : ring) {
    low = {std::min(low.lat, corner.lat), std::min(low.lon, corner.lon)};
    high = {std::max(high.lat, corner.lat), std::max(high.lon, corner.lon)};
  }
  for (int tries = 0; tries < kMostTries; ++tries) {
    const Corner corner{static_cast<int>(random.uniform(low.lat, high.lat)),
                        static_cast<int>(random.uniform(low.lon, high.lon))};
    if (turns_around(ring, corner) != 0 && within(*zone, corner)) {
      return point_of(corner);
    }
  }
  return zone->centre;
}

}  // namespace evbal

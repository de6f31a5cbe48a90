#include "tools/ingest/zone_places.hpp"

#include "common/random.hpp"
#include "tools/ingest/zone_ids.hpp"
#include "tools/records/dropped.hpp"

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

}  // namespace

ZonePlaces::ZonePlaces(const std::vector<Zone>& zones, char decimal) : decimal_(decimal) {
  shapes_.reserve(zones.size());
  for (const Zone& zone : zones) {
    const Shape& shape = shapes_.emplace_back(shape_of(zone));
    names_.emplace(zone.name, &shape);
    if (const auto number = whole_number(zone.name)) {
      const auto [known, is_new] = numbers_.emplace(*number, &shape);
      known->second = is_new ? &shape : nullptr;
    }
  }
}

ZonePlaces::Shape ZonePlaces::shape_of(const Zone& zone) {
  Shape shape{&zone, {}};
  double areas = 0.0;
  for (const auto& ring : zone.rings) {
    // A border that crosses itself may have no area; the zone's only ring counts in any case.
    if (signed_area(ring) > 0.0 || zone.rings.size() == 1) {
      Part part{&ring, ring.front(), ring.front(), areas += signed_area(ring)};
      for (const Corner& corner : ring) {
        part.low = {std::min(part.low.lat, corner.lat), std::min(part.low.lon, corner.lon)};
        part.high = {std::max(part.high.lat, corner.lat), std::max(part.high.lon, corner.lon)};
      }
      shape.parts.push_back(part);
    }
  }
  return shape;
}

const ZonePlaces::Shape* ZonePlaces::shape_named(std::string_view name) const {
  const auto exact = names_.find(name);
  if (exact != names_.end()) {
    return exact->second;
  }
  const auto number = whole_number(name, decimal_);
  const auto found = number ? numbers_.find(*number) : numbers_.end();
  return found == numbers_.end() ? nullptr : found->second;
}

std::string ZonePlaces::no_zone() const {
  return "in a zone without polygon; one that has it is " + shown(shapes_.front().zone->name);
}

const Zone* ZonePlaces::zone_of(std::string_view name) const {
  const Shape* shape = shape_named(name);
  return shape == nullptr ? nullptr : shape->zone;
}

std::optional<LatLon> ZonePlaces::place(std::string_view name, std::uint64_t draw) const {
  const Shape* shape = shape_named(name);
  if (shape == nullptr) {
    return std::nullopt;
  }
  if (shape->parts.empty()) {
    return shape->zone->centre;
  }
  RandomStream random(0, Purpose::trip_end, {.index = draw});
  auto part = shape->parts.begin();
  if (shape->parts.size() > 1) {
    const double drawn = random.uniform(0.0, shape->parts.back().areas);
    part = std::upper_bound(part, std::prev(shape->parts.end()), drawn,
                            [](double area, const Part& other) { return area < other.areas; });
  }
  for (int tries = 0; tries < kMostTries; ++tries) {
    const Corner corner{static_cast<int>(random.uniform(part->low.lat, part->high.lat)),
                        static_cast<int>(random.uniform(part->low.lon, part->high.lon))};
    if (turns_around(*part->ring, corner) != 0 && within(*shape->zone, corner)) {
      return point_of(corner);
    }
  }
  return shape->zone->centre;
}

}  // namespace evbal

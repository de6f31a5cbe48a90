#include "tools/ingest/zone_collector.hpp"

#include <algorithm>

namespace evbal {
namespace {

using Ring = std::vector<Corner>;

constexpr int kHalfTurn = 180'000'000;  // millionths of a degree

/// The ring from its smallest corner on, so that equal rings compare equal.
Ring turned(Ring ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

/// Adds the rings that the zone does not have yet.
void add_rings(Zone& zone, const std::vector<Ring>& rings) {
  for (const Ring& ring : rings) {
    const bool known = std::any_of(zone.rings.begin(), zone.rings.end(),
                                   [&](const Ring& other) { return turned(other) == turned(ring); });
    if (!known) {
      zone.rings.push_back(ring);
    }
  }
}

}  // namespace

Error ZoneCollector::error(std::size_t position, const std::string& message) const {
  return bad_input(file_, 0, kind_ + " " + std::to_string(position) + ": " + message);
}

void ZoneCollector::drop(std::size_t position, const std::string& reason) {
  dropped_.add(reason, file_ + ": " + kind_ + " " + std::to_string(position), {});
}

void ZoneCollector::add(std::size_t position, Zone polygon, std::string name, std::optional<double> weight) {
  polygon.name = name.empty() ? std::to_string(position) : std::move(name);
  const auto [known, is_new] = by_name_.try_emplace(polygon.name, zones_.size());
  if (!is_new) {
    first_joined_ = joined_++ > 0 ? first_joined_ : kind_ + " " + std::to_string(position) + ": " + shown(polygon.name);
    join(known->second, polygon, weight);
    return;
  }
  weights_.push_back(weight ? std::optional(Weights{*weight, weight}) : std::nullopt);
  zones_.push_back(std::move(polygon));
}

void ZoneCollector::join(std::size_t zone, const Zone& polygon, std::optional<double> weight) {
  add_rings(zones_[zone], polygon.rings);
  if (weight) {
    Weights& weights = *weights_[zone];
    weights.sum += *weight;
    // Programs that take a zone apart copy its fields to each part.
    weights.of_each = weights.of_each == weight ? weight : std::nullopt;
  }
}

/// A city across 180 degrees has corners at both ends of the map: brings them together at its eastern end.
void ZoneCollector::cross_180() {
  const auto for_each_corner = [&](auto use) {
    for (Zone& zone : zones_) {
      for (Ring& ring : zone.rings) {
        std::for_each(ring.begin(), ring.end(), use);
      }
    }
  };
  constexpr int kNone = 3 * kHalfTurn;
  int least_east = kNone;  // longitude from 0 on
  int most_west = -kNone;  // longitude below 0
  for_each_corner([&](Corner corner) {
    if (corner.lon < 0) {
      most_west = std::max(most_west, corner.lon);
    } else {
      least_east = std::min(least_east, corner.lon);
    }
  });
  const bool both = least_east < kNone && most_west > -kNone;
  if (both && least_east - most_west > kHalfTurn) {
    for_each_corner([](Corner& corner) { corner.lon += corner.lon < 0 ? 2 * kHalfTurn : 0; });
  }
}

std::string ZoneCollector::report() const {
  std::string lines = "zones read: " + std::to_string(zones_.size()) + "\n" + dropped_.report();
  if (joined_ > 0) {
    lines +=
        "  polygons put to another of the same name: " + std::to_string(joined_) + " (first: " + first_joined_ + ")\n";
  }
  return lines;
}

ZoneFile ZoneCollector::finish() {
  if (zones_.empty()) {
    throw bad_input(file_, 0, "has no polygon");
  }
  cross_180();
  std::size_t crossed = 0;
  std::string first_crossed;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    measure(zones_[z]);
    if (zones_[z].area_m2 <= 0.0) {
      first_crossed = crossed++ > 0 ? first_crossed : shown(zones_[z].name);
    }
    const auto& weights = weights_[z];
    zones_[z].weight = weights ? weights->of_each.value_or(weights->sum) : zones_[z].area_m2;
  }
  std::string lines = report();
  if (crossed > 0) {
    lines += "  without area, since their border crosses itself: " + std::to_string(crossed) +
             " (first: " + first_crossed + ")\n";
  }
  return {std::move(zones_), std::move(lines)};
}

}  // namespace evbal

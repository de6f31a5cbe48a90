#include "tools/gps/rides.hpp"

#include "agents/world/geometry.hpp"

#include <cmath>
#include <numbers>

namespace evbal {

double metres_between(const Fix& a, const Fix& b) {
  // A sphere is good to half a per cent, and many times faster than the ellipsoid.
  constexpr double kDegree = std::numbers::pi / 180.0;
  constexpr double kRadius = 6'371'000.0;  // m
  const double north = (b.place.lat - a.place.lat) * kDegree;
  const double east = (b.place.lon - a.place.lon) * kDegree * std::cos((a.place.lat + b.place.lat) / 2.0 * kDegree);
  return kRadius * std::hypot(north, east);
}

std::optional<VacantMove> RideFinder::end_vacant(const Fix& to, VacantMove::End end) {
  std::optional<VacantMove> move;
  if (vacant_from_ && to.time > vacant_from_->time) {
    move = VacantMove{*vacant_from_, to, vacant_km_, end};
  }
  vacant_from_.reset();
  vacant_km_ = 0.0;
  return move;
}

RideFinder::Found RideFinder::add(const Fix& fix) {
  Found found;
  const bool free_before = last_ && !last_->occupied;
  if (free_before && static_cast<double>(fix.time - last_->time) > 60.0 * longest_gap_) {
    found.vacant = end_vacant(*last_, VacantMove::End::gap);
  } else if (free_before) {
    vacant_km_ += metres_between(*last_, fix) / 1000.0;
    if (fix.occupied) {
      found.vacant = end_vacant(fix, VacantMove::End::pickup);
    }
  }
  if (fix.occupied && free_before) {
    pickup_ = fix;
  } else if (!fix.occupied && last_ && last_->occupied) {
    if (pickup_) {
      found.ride = Ride{*pickup_, fix};
    } else {
      ++cut_off_;
    }
    pickup_.reset();
  }
  if (!fix.occupied && !vacant_from_) {
    vacant_from_ = fix;
  }
  last_ = fix;
  return found;
}

std::optional<VacantMove> RideFinder::finish() {
  if (last_ && last_->occupied) {
    ++cut_off_;
  }
  return last_ && !last_->occupied ? end_vacant(*last_, VacantMove::End::records) : std::nullopt;
}

}  // namespace evbal

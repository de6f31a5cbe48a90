#pragma once

#include "experiments/bound/capacity_bound.hpp"
#include "experiments/bound/interior_point.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace evbal {

/// Cars that drive so many km without passengers and lose so many passengers.
struct Driving {
  double km = 0.0;    ///< of a day
  double lost = 0.0;  ///< passengers, not whole where cars are shared
};

/// The bound at one price of a lost passenger.
struct BoundPoint {
  double price = 0.0;  ///< km a lost passenger
  /// No day that is played comes below: price x lost + km is at least this.
  double bound = 0.0;
  bool tight = false;             ///< whether the bound is the best of its network; else the time ran out before
  std::optional<Driving> down{};  ///< what cars do at the bound, if tight: arrivals are rounded down
  std::optional<Driving> up{};    ///< the best with arrivals rounded up, which is nearly attainable; none if not found

  /// How much higher the cost of `up` lies than the bound, relative to it; none without `up`.
  std::optional<double> bracket() const;

  /// Whether nothing more can be found.
  bool complete() const { return tight && up.has_value(); }
};

/// The bound of a day.
struct DayBound {
  int passengers = 0;              ///< who can be lost
  CapacityBound capacity;          ///< at any km
  std::vector<BoundPoint> points;  ///< by price, ascending
};

/// How far the bound of a day has come.
struct BoundProgress {
  std::size_t point = 0;               ///< of the prices
  Rounding rounding = Rounding::down;  ///< that is being solved
  const PricedFlow* flow = nullptr;    ///< so far
};

/// The front of a day at `prices`, which are > 0 and ascending. `stop` is asked before every iteration; once it is true
/// the points are left as far as they are, each with a true bound. Throws Error{bad_input} if the day is too large to
/// be solved.
DayBound day_bound(const BoundDay& day, const std::vector<double>& prices,
                   const std::function<bool(const BoundProgress&)>& stop);

/// All points of two bounds of the same day; of those at the same price the complete one or else the higher one.
DayBound merged(const DayBound& one, const DayBound& other);

/// The fewest passengers that a day loses at some km, by all points and the capacity bound.
double fewest_lost(const DayBound& bound, double km);

/// The corners of fewest_lost from 0 km on, by km.
std::vector<Driving> bound_corners(const DayBound& bound);

}  // namespace evbal

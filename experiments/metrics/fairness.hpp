#pragma once

#include <span>

namespace evbal {

/// One plan's outcome in every region: what was there after its dispatch and what happened over the following
/// step length. All spans have one entry per region.
struct Outcome {
  std::span<const double> demand;       ///< r: passengers who appeared over the window
  std::span<const double> supply;       ///< S: vacant vehicles after the executed dispatch
  std::span<const double> drop_offs;    ///< A: vehicles that dropped a passenger off over the window
  std::span<const double> completions;  ///< c: charging sessions that ended over the window
  std::span<const double> low_battery;  ///< Y: low-battery vehicles after the executed dispatch
  std::span<const int> points;          ///< installed charging points; fairness of charging looks at regions with any
};

/// Distances from an even share; 0 is perfectly fair.
struct Unfairness {
  double demand = 0.0;            ///< sum_i |r_i / max(S_i, 1) - sum r / max(sum S, 1)|
  double demand_shares = 0.0;     ///< sum_i |r_i / sum r - S_i / sum S|; a sum of 0 makes all its shares 0
  double demand_drop_offs = 0.0;  ///< as `demand`, with S_i + phi A_i for S_i, phi = 0.6
  double charging = 0.0;          ///< sum_{i in C} |c_i / max(Y_i, 1) - sum c / max(sum Y, 1)|, C = regions with points
  double charging_shares = 0.0;   ///< sum_{i in C} |c_i / sum c - Y_i / sum Y|

  /// Adds another, number by number.
  Unfairness& operator+=(const Unfairness& other);
  /// Divides each number.
  Unfairness operator/(double divisor) const;
};

/// Unfairness of the supply-demand ratio and of utilisation ("Unfairness", docs/metrics.md).
Unfairness unfairness(const Outcome& outcome);

}  // namespace evbal

#pragma once

#include "common/eigen.hpp"
#include "coordinator/planning/city_model.hpp"

#include <vector>

namespace evbal {

/// What a vehicle is for the balancing problem (docs/model.md, section 2). Cars under way count at their destination.
enum class CarState { vacant, low_battery, plugged, occupied, rebalancing, to_charger };

/// What a vehicle is, and where.
struct CarPlace {
  CarState state = CarState::vacant;  ///< what it is
  int region = 0;                     ///< where it is, or will be
};

/// How many cars of each region were in which state, and where, one step later.
struct TransitionCounts {
  Eigen::MatrixXd vacant;    ///< N x 3N: vacant, occupied, low-battery
  Eigen::MatrixXd occupied;  ///< N x 2N: vacant, occupied

  /// Counts nothing yet.
  explicit TransitionCounts(int regions);

  /// Adds a step: by vehicle, where each was just after dispatch (cars sent off at that moment are where they go
  /// already, vacant as before) and where it is a step later, before the next dispatch. Cars that are plugged, wait for
  /// a charger, or were on the road empty at the start are known to the problem as data and are left out; what became
  /// of the others counts
  ///   vacant: also when on a new way without passengers,
  ///   low-battery: also when on the way to a charger or plugged by now; those that were occupied count as vacant, for
  ///   Q has no such state, and leave it in the step after.
  void add(const std::vector<CarPlace>& start, const std::vector<CarPlace>& end);

  /// Adds others.
  TransitionCounts& operator+=(const TransitionCounts& other);
};

/// Minutes after midnight at which the periods of the day begin in which transitions differ; the last ends at midnight.
const std::vector<int>& transition_periods();

/// Cars that a row of counts is shrunk by (transitions_of).
inline constexpr double transition_prior = 50.0;

/// The period that holds `minute` after midnight, of those that begin at `starts`, ascending; the first before that.
std::size_t period_at(const std::vector<int>& starts, int minute);

/// Shares of the counts of a period. A row with n cars is shrunk towards the row of `day` as if that were `prior`
/// cars more, and that towards cars that stay what and where they are by as many: rows seen rarely are never empty.
/// Shares are multiples of 1e-6; rows sum to one.
Transitions transitions_of(const TransitionCounts& period, const TransitionCounts& day, double prior);

/// Shares by period, of counts for each of transition_periods(), shrunk towards their sum by transition_prior.
std::vector<Period> periods_of(const std::vector<TransitionCounts>& counts);

}  // namespace evbal

#pragma once

#include "common/eigen.hpp"
#include "coordinator/balancing/problem.hpp"

namespace evbal {

/// Passengers who want a car, region by region, from now on: those of the passengers who wait now that are still there
/// to be served, and the forecast of those who appear, evenly within each step. After the horizon as in its last step.
class CumulativeDemand {
 public:
  /// Reads the forecast and who waits.
  explicit CumulativeDemand(const PlanningData& data);

  /// Expected passengers of `region` in the next `minutes`, at least 0.
  double within(double minutes, Eigen::Index region) const;

 private:
  double step_minutes_;
  Eigen::MatrixXd until_;  ///< N x (tau + 1): before each step, and before the end of the last
};

}  // namespace evbal

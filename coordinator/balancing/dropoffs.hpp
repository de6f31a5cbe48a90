#pragma once

#include "common/eigen.hpp"
#include "coordinator/balancing/problem.hpp"

namespace evbal {

/// Share of the passengers who wait now that are still there to be served by what is planned.
inline constexpr double still_there = 0.8;

/// Demand of each step as `turnover` sees it, N x tau: the forecast and, in the first step, those of the passengers who
/// wait now that are still there to be served (docs/model.md, section 4).
Eigen::MatrixXd demand_with_waiting(const PlanningData& data);

/// A, N x tau: cars that drop a passenger off in region i within the step, those due already and those that serve
/// `demand` from `vacant` (N x tau both) and are done within the step (docs/model.md, section 4):
///     A_i = due_i + sum_j served_j D_ji,      served = min(demand, vacant + 0.8 A)
Eigen::MatrixXd dropoffs(const PlanningData& data, const Eigen::MatrixXd& demand, const Eigen::MatrixXd& vacant);

/// phi (1 - pl) A, N x tau: those of the drop-offs that serve again in the step. pl_i is the share of the vacant cars
/// of region i that come out of the step with a low battery.
Eigen::MatrixXd serving_again(const PlanningData& data, const Eigen::MatrixXd& dropoffs);

}  // namespace evbal

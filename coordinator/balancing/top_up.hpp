#pragma once

#include "common/eigen.hpp"
#include "coordinator/balancing/formulation.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/balancing/round_to_vehicles.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <vector>

/// Top-up charging: a vacant car that is not full may be told to charge where it stands, at a point that no low-battery
/// car needs (docs/model.md, section 2). One rule for every controller.
namespace evbal {

/// T, N: vacant cars that may be told to charge where they stand. Points that stay free when every low-battery car that
/// is there or on its way has one, and no more than are chargeable; whole numbers.
Eigen::VectorXd top_up_room(const PlanningData& data);

/// Adds  0 <= t_i <= T_i  for every region with T_i > 0, and the cost  top_up sum_i (T_i - t_i)  ("top-up"), to a
/// program, whose rows have to take the cars out of what is vacant for a session's mean length. By region, each as a
/// flow from the region to itself.
std::vector<ArcFlow> add_top_ups(const BalancingParameters& parameters, const PlanningData& data,
                                 ConvexProgram& program);

/// Top-ups as whole vehicles, within T and what `sent`, the vacant vehicles that leave, leaves of those that are there.
std::vector<VehicleFlow> whole_top_ups(const std::vector<Flow>& flows, const PlanningData& data,
                                       const std::vector<VehicleFlow>& sent);

}  // namespace evbal

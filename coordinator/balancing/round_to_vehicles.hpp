#pragma once

#include "coordinator/balancing/problem.hpp"

#include <Eigen/Core>

#include <vector>

namespace evbal {

/// Vehicles to send, at least one.
struct VehicleFlow {
  int from = 0;
  int to = 0;
  int vehicles = 0;
};

/// Flows as whole vehicles, by (from, to): each origin sends its rounded total, at most what it has, to the targets of
/// largest remainder (ties: the lower index). Amounts are first rounded to 1e-6, so that the last digits of a solver
/// never decide. `flows` is ordered by (from, to); `available` holds whole numbers, N.
std::vector<VehicleFlow> round_to_vehicles(const std::vector<Flow>& flows, const Eigen::VectorXi& available);

}  // namespace evbal

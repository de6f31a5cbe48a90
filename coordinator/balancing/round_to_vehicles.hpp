#pragma once

#include "common/eigen.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/balancing/send_limits.hpp"

#include <vector>

namespace evbal {

/// Vehicles to send, at least one.
struct VehicleFlow {
  int from = 0;      ///< region
  int to = 0;        ///< region
  int vehicles = 0;  ///< at least 1
};

/// Flows as whole vehicles, by (from, to): each origin sends its rounded total, at most what it has, to the targets of
/// largest remainder (ties: the lower index). Amounts are first rounded to 1e-6, so that the last digits of a solver
/// never decide. `available` holds N numbers of at least zero; flows run between two of the N regions, in any order,
/// with amounts within [0, 1e6]; what a pair has twice counts together. Vehicles for which `limits` leave no room stay.
std::vector<VehicleFlow> round_to_vehicles(const std::vector<Flow>& flows, const Eigen::VectorXi& available,
                                           const std::vector<SendLimit>& limits = {});

}  // namespace evbal

#pragma once

#include "agents/world/city.hpp"
#include "common/eigen.hpp"

#include <vector>

namespace evbal {

/// Regions r0, r1, ... in a plane at 0 N, 0 E whose distances are as near to `km`, N x N, as classical multidimensional
/// scaling brings them. Each is a square around its place that reaches a quarter of the way to the nearest other one.
std::vector<Region> regions_by_distance(const Eigen::MatrixXd& km);

}  // namespace evbal

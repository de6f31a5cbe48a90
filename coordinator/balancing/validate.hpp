#pragma once

#include "coordinator/balancing/problem.hpp"

#include <string>

namespace evbal {

/// Why a plan cannot be made from these numbers, naming the first datum that is wrong ("vacant vehicles of region 3:
/// nan is not in [0, 1e+06]"); empty if all are sound: finite, not negative and not beyond any city, rows of
/// transitions that sum to one, deviations above zero. `km` and `minutes` may be infinite where there is no road.
/// Shapes that do not fit together are the programmer's error.
std::string validate(const BalancingParameters& parameters, const PlanningData& data);

}  // namespace evbal

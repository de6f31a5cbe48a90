#pragma once

#include "coordinator/balancing/problem.hpp"

#include <string>

namespace evbal {

/// Why a plan cannot be made from these numbers, naming the first datum that is wrong ("vacant vehicles of region 3 are
/// nan"), empty if all are sound: finite and not negative, rows of transitions that sum to one, deviations above zero.
/// `km` and `minutes` may be infinite where there is no road. Shapes that do not fit together are the programmer's
/// error.
std::string complaint(const BalancingParameters& parameters, const PlanningData& data);

}  // namespace evbal

#pragma once

#include "coordinator/balancing/problem.hpp"

namespace evbal {

/// No balancing: low-battery cars go to the nearest region with working points and stay there (docs/model.md, section
/// 4).
Dispatch plan_none(const PlanningData& data);

/// The dispatcher's rule of thumb (docs/model.md, section 4). Vacant cars: the nearest pair of a region with cars to
/// spare and a region that lacks some, again and again, within `m1`; what is under way counts. Who is still to spare
/// tops up where there is room for it. Low-battery cars: one by one to the station of least travel minutes + expected
/// wait within `m2` and their charge, those in the queue included.
Dispatch plan_greedy(const BalancingParameters& parameters, const PlanningData& data);

}  // namespace evbal

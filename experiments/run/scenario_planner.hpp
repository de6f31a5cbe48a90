#pragma once

#include "coordinator/planning/receding_horizon_planner.hpp"
#include "experiments/scenario/scenario.hpp"

#include <memory>

namespace evbal {

/// What plans the day of a scenario under its controller, one of evbal's own, in this process; with `balancer`, if that
/// is given, in place of the scenario's. Throws Error{bad_input} if the model is missing or does not fit.
std::shared_ptr<RecedingHorizonPlanner> planner_of(const Scenario& scenario, const Balancer& balancer = {});

}  // namespace evbal

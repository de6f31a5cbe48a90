#pragma once

#include "coordinator/balancing/engine.hpp"
#include "coordinator/balancing/problem.hpp"

#include <string>
#include <vector>

namespace evbal {

/// Makes one plan over the horizon that `data` spans. `controller` is one of controller_names(), `engine.name` one of
/// engine_names(). Never throws for what the data hold: data that are no numbers and solves that fail give a
/// certificate that is not optimal and says why. Controllers that solve nothing (none, greedy) have objective, bound
/// and gap 0.
BalancingResult balance(const std::string& controller, const BalancingParameters& parameters, const PlanningData& data,
                        const EngineSettings& engine);

std::vector<std::string> controller_names();

}  // namespace evbal

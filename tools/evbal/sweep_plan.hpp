#pragma once

#include "experiments/study/design/sweep.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// What of a sweep is played and what is left, a row for each scenario and variant, and how long that will take: by
/// the mean seconds of the variant's days that are played (seconds_of_results), `jobs` >= 1 at a time. `failed`: as of
/// failures_in.
std::string sweep_plan(const Sweep& sweep, const std::vector<std::string>& keys,
                       const std::map<std::string, std::optional<double>>& played,
                       const std::map<std::string, std::string>& failed, int jobs);

}  // namespace evbal

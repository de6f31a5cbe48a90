#pragma once

#include "experiments/study/design/tuned.hpp"
#include "experiments/study/design/tuning.hpp"

#include <string>
#include <vector>

/// How sure a tuning is of what it chose (docs/tuning.md).
namespace evbal {

/// The winners of contests that are decided, each with what its search spent and found.
Tuned judged_winners(const Tuning& tuning, const std::vector<Contest>& contests);

/// A table of what was spent and found, a row for each scenario and variant that says so, under a row of headings.
std::vector<std::vector<std::string>> tuned_rows(const Tuned& tuned);

}  // namespace evbal

#pragma once

#include "experiments/record/run_record.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The totals of runs side by side, a column a run, aligned for a terminal.
std::string side_by_side(const std::vector<RunResult>& results);

}  // namespace evbal

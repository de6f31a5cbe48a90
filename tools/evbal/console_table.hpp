#pragma once

#include "experiments/record/paired_run.hpp"
#include "experiments/record/run_record.hpp"
#include "experiments/study/executors/monte_carlo.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// The totals of runs side by side, a column a run, aligned for a terminal.
std::string side_by_side(const std::vector<RunResult>& results);

/// What the faults of a run cost, a row a metric, aligned likewise.
std::string cost_table(const std::vector<MetricCost>& costs);

/// How metrics are spread over draws, a row a metric, with its value without faults, aligned likewise.
std::string distribution_table(const std::vector<DrawnMetric>& metrics);

/// The five drawn quantities that a metric goes with most closely, aligned likewise.
std::string influence_table(const std::vector<Influence>& influences);

/// Rows of cells in columns, the first `left` of them flush left, the others flush right.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left);

}  // namespace evbal

#pragma once

#include "experiments/study/statistics/comparison.hpp"
#include "experiments/study/statistics/markdown.hpp"

#include <string>

/// How comparisons stand in tables, in a terminal and on a page.
namespace evbal {

/// What the columns of comparison_cells are called, with the names of the two that hold the metric.
Words comparison_head(const Question& question, const std::string& value, const std::string& reference);

/// A row's numbers: where it was compared, the metric on both sides, the difference with its interval, and of what that
/// was made.
Words comparison_cells(const Compared& row, const Question& question);

/// The difference, in per cent if it is relative.
std::string difference_text(const Compared& row);

/// Its interval, or that it is not known.
std::string interval_text(const Compared& row);

}  // namespace evbal

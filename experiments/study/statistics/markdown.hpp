#pragma once

#include "experiments/study/statistics/intervals.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// What the page's tables are written with.
namespace evbal {

/// Texts in a row.
using Words = std::vector<std::string>;

/// With three digits, or whole.
std::string rounded(double value);

/// As many decimals as tell values of that size apart to three digits.
int digits_for(double size);

/// "low .. high", both times `factor`, or that it is not known.
std::string range(const Interval& interval, double factor, int digits, bool sign);

/// A row of a Markdown table, with its line break.
std::string table_row(const Words& cells);

/// A table's head, the first `left` columns of which are flush left.
std::string header(const Words& cells, std::size_t left);

/// Whether one of the words is `word`.
bool contains(const Words& words, const std::string& word);

}  // namespace evbal

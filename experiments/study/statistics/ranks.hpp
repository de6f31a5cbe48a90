#pragma once

#include <vector>

namespace evbal {

/// Spearman's rank correlation of two lists of the same length, equal values at their mean rank; 0 if all values of a
/// list are equal.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace evbal

#pragma once

#include <vector>

namespace evbal {

/// Twice each value's rank, equal values at their mean rank, less its mean over all: whole numbers.
std::vector<double> centred_ranks(const std::vector<double>& values);

/// Spearman's rank correlation of two lists of the same length, equal values at their mean rank; 0 if all values of a
/// list are equal.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace evbal

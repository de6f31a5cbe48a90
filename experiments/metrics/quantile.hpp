#pragma once

#include <vector>

namespace evbal {

/// The quantile of `values` for a probability in [0, 1], linear between order statistics; 0 of nothing.
double quantile(std::vector<double> values, double probability);

}  // namespace evbal

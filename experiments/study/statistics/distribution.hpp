#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// How a metric is spread over several runs; quantiles are linear between order statistics.
struct Distribution {
  double min = 0.0;     ///< least value
  double q1 = 0.0;      ///< lower quartile
  double median = 0.0;  ///< middle value
  double q3 = 0.0;      ///< upper quartile
  double p90 = 0.0;     ///< 90th percentile
  double max = 0.0;     ///< greatest value
  double mean = 0.0;    ///< arithmetic
};

/// Of one value at least.
Distribution distribution_of(const std::vector<double>& values);

/// The numbers by name, in the order of the files.
std::vector<std::pair<std::string, double>> named(const Distribution& distribution);

/// Position of the largest value, or of the smallest; the first of several.
std::size_t worst_of(const std::vector<double>& values, bool largest);

}  // namespace evbal

#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// How a metric is spread over several runs; quantiles are linear between order statistics.
struct Distribution {
  double min = 0.0;
  double q1 = 0.0;
  double median = 0.0;
  double q3 = 0.0;
  double p90 = 0.0;
  double max = 0.0;
  double mean = 0.0;
};

/// Of one value at least.
Distribution distribution_of(const std::vector<double>& values);

/// The numbers by name, in the order of the files.
std::vector<std::pair<std::string, double>> named(const Distribution& distribution);

/// Position of the largest value, or of the smallest; the first of several.
std::size_t worst_of(const std::vector<double>& values, bool largest);

}  // namespace evbal

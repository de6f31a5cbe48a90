#include "experiments/study/statistics/distribution.hpp"

#include "common/contract.hpp"
#include "experiments/metrics/quantile.hpp"

#include <algorithm>
#include <numeric>

namespace evbal {

Distribution distribution_of(const std::vector<double>& values) {
  EVBAL_EXPECT(!values.empty(), "at least one value");
  return {.min = quantile(values, 0.0),
          .q1 = quantile(values, 0.25),
          .median = quantile(values, 0.5),
          .q3 = quantile(values, 0.75),
          .p90 = quantile(values, 0.9),
          .max = quantile(values, 1.0),
          .mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size())};
}

std::vector<std::pair<std::string, double>> named(const Distribution& distribution) {
  return {{"min", distribution.min},  {"q1", distribution.q1},   {"median", distribution.median},
          {"q3", distribution.q3},    {"p90", distribution.p90}, {"max", distribution.max},
          {"mean", distribution.mean}};
}

std::size_t worst_of(const std::vector<double>& values, bool largest) {
  const auto worst =
      largest ? std::max_element(values.begin(), values.end()) : std::min_element(values.begin(), values.end());
  return static_cast<std::size_t>(worst - values.begin());
}

}  // namespace evbal

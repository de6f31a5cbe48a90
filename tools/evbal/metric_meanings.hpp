#pragma once

#include <string>
#include <vector>

namespace evbal {

/// What a metric of a day is (docs/metrics.md).
struct MetricMeaning {
  std::string name;     ///< as summary.json has it
  std::string unit;     ///< empty if it has none
  std::string meaning;  ///< in a line
};

/// Of every metric of a day, in the order of metric_names().
const std::vector<MetricMeaning>& metric_meanings();

}  // namespace evbal

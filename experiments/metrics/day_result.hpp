#pragma once

#include "experiments/metrics/metrics.hpp"

#include <string>

namespace evbal {

/// What a played day came to, without its record.
struct DayResult {
  DayMetrics metrics;  ///< what it came to
  std::string digest;  ///< of all that was said
  int fallbacks = 0;   ///< plans that were not the controller's own
};

}  // namespace evbal

#pragma once

#include "common/clock.hpp"
#include "experiments/metrics/metrics.hpp"

#include <string>

namespace evbal {

/// steps.csv: a header, then a row a step with the time at which it starts and the columns of CityStep.
std::string steps_csv(const DayClock& clock, const DayMetrics& day);

/// regions.csv: likewise, a row a step and region.
std::string regions_csv(const DayClock& clock, const DayMetrics& day);

}  // namespace evbal

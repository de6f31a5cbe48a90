#pragma once

#include "experiments/study/statistics/fault_influence.hpp"
#include "faults/schedule/schedule.hpp"

#include <vector>

namespace evbal {

/// What differs between draws of one schedule, by fault in the order of the schedule: `times` that it strikes, `start`
/// of the first (minutes after midnight), `minutes` in all, `magnitude` and `regions` summed over its times, and
/// `in region R`, 1 or 0, for regions that three draws at least have and three have not. A fault that strikes more or
/// less often is one by the name that it has in the schedule. `day_start` is the minute at which days begin.
std::vector<DrawnQuantity> drawn_quantities(const std::vector<Schedule>& draws, int day_start);

}  // namespace evbal

#pragma once

#include "common/clock.hpp"
#include "faults/schedule/schedule.hpp"

#include <string>

namespace evbal {

/// "charger.outage of 2 points in region 12 from 17:10 for 40 minutes"
std::string described(const Fault& fault, const DayClock& clock);

/// All faults of a schedule by time, with commas and an "and" between; "no fault" if it has none.
std::string described(const Schedule& schedule, const DayClock& clock);

}  // namespace evbal

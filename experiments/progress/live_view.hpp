#pragma once

#include "common/clock.hpp"
#include "experiments/progress/day_state.hpp"

#include <string>
#include <vector>

namespace evbal {

/// "43 s" or "12 min 5 s".
std::string shown_seconds(double seconds);

/// The day in one line, `title` first.
std::string live_line(const std::string& title, const DayClock& clock, const DayState& day, double seconds_left);

/// The day in some lines of at most `columns` (at least 20) characters each: clock, passengers, a bar for each region's
/// demand, vacant vehicles and queue, faults, where the last plan came from. Neighbouring regions share a bar where
/// there are more of them than room.
std::vector<std::string> live_view(const std::string& title, const DayClock& clock, const DayState& day,
                                   double seconds_left, int columns);

}  // namespace evbal

#pragma once

#include "common/clock.hpp"
#include "experiments/progress/day_state.hpp"

#include <chrono>
#include <set>
#include <string>
#include <vector>

namespace evbal {

/// Shows on stderr how far a day has come: a few lines that renew themselves on a terminal, else one line every
/// simulated hour.
class Progress {
 public:
  /// `fault_names` by position in the schedule.
  Progress(std::string title, DayClock clock, std::vector<std::string> fault_names, bool quiet);

  /// Takes the next tick.
  void show(const TickRecord& record);

 private:
  void redraw(const std::vector<std::string>& lines);

  std::string title_;
  DayClock clock_;
  bool quiet_;
  bool terminal_;
  std::size_t drawn_ = 0;  ///< lines above the cursor that are ours
  std::chrono::steady_clock::time_point start_;
  std::set<std::string> seen_;  ///< faults since the last of the lines by the hour
  DayWatch watch_;
};

}  // namespace evbal

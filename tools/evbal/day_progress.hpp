#pragma once

#include "agents/protocol/tick_record.hpp"
#include "common/clock.hpp"
#include "experiments/progress/day_state.hpp"
#include "experiments/run/day_door.hpp"
#include "experiments/scenario/scenario.hpp"

#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace evbal {

/// Shows on stderr how far a day has come: a few lines that renew themselves on a terminal, else one line every
/// simulated hour.
class DayProgress {
 public:
  /// Shows nothing before the first tick.
  explicit DayProgress(const Scenario& scenario);

  /// Takes the next tick.
  void show(const TickRecord& record);

  /// The schedule has one more fault.
  void add_fault(const std::string& name) { watch_.add_fault(name); }

  /// Says once that the day has been paused, or goes on.
  void note_pace(const DayPace& pace);

 private:
  void redraw(const std::vector<std::string>& lines);

  std::string title_;
  DayClock clock_;
  bool terminal_;
  std::size_t drawn_ = 0;  ///< lines above the cursor that are ours
  std::chrono::steady_clock::time_point start_;
  bool paused_ = false;
  std::set<std::string> seen_;  ///< faults since the last of the lines by the hour
  DayWatch watch_;
};

/// What record_day tells of its ticks, shown; nothing if `quiet`.
std::function<void(const TickRecord&)> shown_day(const Scenario& scenario, bool quiet);

}  // namespace evbal

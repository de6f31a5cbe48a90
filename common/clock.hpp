#pragma once

#include <string>

namespace evbal {

/// The simulated day, in whole minutes. All times elsewhere are minutes since the day's start unless they say
/// otherwise.
struct DayClock {
  int start = 5 * 60;   ///< minute after midnight at which the day starts
  int end = 24 * 60;    ///< minute after midnight at which it ends
  int tick = 5;         ///< minutes between exchanges of vehicles; divides `step` and `plan_every`
  int step = 30;        ///< Delta: the controller's and the record's unit; divides end - start
  int plan_every = 10;  ///< minutes between plans

  /// Length of the day.
  int minutes() const { return end - start; }
  /// Number of ticks in the day.
  int ticks() const { return minutes() / tick; }
  /// Number of steps in the day.
  int steps() const { return minutes() / step; }
  /// Minute at which a tick begins.
  int minute_of(int tick_index) const { return tick_index * tick; }
  /// Step that a minute belongs to.
  int step_of(int minute) const { return minute / step; }
  /// Whether a plan is due at the start of a tick.
  bool plan_due(int tick_index) const { return minute_of(tick_index) % plan_every == 0; }

  /// What is wrong with the clock, and what would be right; empty if nothing is.
  std::string validate() const;
};

/// "17:30" for a minute since the day's start.
std::string time_of_day(const DayClock& clock, int minute);

}  // namespace evbal

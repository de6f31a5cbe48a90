#pragma once

#include "experiments/conductor/conductor.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/metrics/day_result.hpp"
#include "experiments/scenario/scenario.hpp"

#include <vector>

namespace evbal {

/// A plan that was made, and what was known then.
struct PlannedTick {
  Tick tick;                    ///< that it was made for
  std::vector<Report> reports;  ///< that came in time, by region
  std::vector<Move> moves;      ///< of the plan
};

/// A day in this process, without a record, that stands still whenever a plan is due and takes it from its holder. With
/// the plans of a controller of evbal's it is the day that `evbal run` plays.
class SteppedDay {
 public:
  /// Begins the day and goes on to its first plan. Whatever the scenario says of controllers, coordinator and transport
  /// does not matter. Throws Error{run_failed}.
  explicit SteppedDay(const Scenario& scenario);
  SteppedDay(const SteppedDay&) = delete;
  SteppedDay& operator=(const SteppedDay&) = delete;

  /// What is played.
  const Scenario& scenario() const { return scenario_; }

  /// Whether the last plan has been made and the day is over.
  bool over() const { return over_; }

  /// The tick that waits for a plan; the last one if the day is over.
  const Tick& tick() const { return tick_; }

  /// What the coordinator hears before it plans, by region: those reports that come in time. Empty if the day is over.
  const std::vector<Report>& reports() const { return reports_; }

  /// Makes this the plan of tick() and goes on to the next one, or to the day's end. Throws Error{run_failed} if the
  /// plan cannot be (Conductor), and the day cannot go on then. The day must not be over.
  void step(Plan plan);

  /// The plans so far, in turn.
  const std::vector<PlannedTick>& planned() const { return planned_; }

  /// The ticks of which all is known, in turn.
  const std::vector<TickRecord>& ticks() const { return ticks_; }

  /// What the day came to, once it is over.
  DayResult result() const;

 private:
  void go_on();

  Scenario scenario_;
  std::vector<TickRecord> ticks_;
  InprocPlayers players_;
  Conductor conductor_;
  Tick tick_;
  Exchange said_;  ///< in tick_, up to the reports
  std::vector<Report> reports_;
  std::vector<PlannedTick> planned_;
  bool over_ = false;
};

}  // namespace evbal

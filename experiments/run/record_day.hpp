#pragma once

#include "experiments/metrics/day_result.hpp"
#include "experiments/record/run_record.hpp"
#include "experiments/scenario/scenario.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// How a day is played, none of which changes what happens in it.
struct Stage {
  std::string transport;  ///< "dds" or "inproc"
  bool quiet = false;     ///< without progress
};

/// How a day is played in this process; over the bus if somebody else makes the plans.
std::string own_transport(const Scenario& scenario);

/// The scenario for one of its controllers.
Scenario with_controller(Scenario scenario, const std::string& controller);

/// The same day without faults, to hold the one with faults against, in this process if it can be.
Scenario without_faults(Scenario scenario);

/// Throws Error{bad_input} if the day cannot be planned: there is no model, or it does not fit city, clock or horizon.
/// Of a coordinator in place of evbal's own it is checked that there is one.
void check_planning(const Scenario& scenario);

/// Plays the day under the scenario's controller and records it in `folder`, which must not exist or be empty;
/// `resolved` is the scenario's text for the record. Shows progress on stderr. Throws Error{run_failed} if the run
/// breaks off, which leaves a record marked as incomplete.
RunResult record_day(const Scenario& scenario, const std::string& resolved, const std::filesystem::path& folder,
                     const Stage& stage);

/// Plays the day and keeps what it came to only: in this process, or by the scenario's transport in `folder`, which is
/// made and goes again. Throws Error{run_failed}.
DayResult play_day(const Scenario& scenario);
DayResult play_day(const Scenario& scenario, const std::filesystem::path& folder);

}  // namespace evbal

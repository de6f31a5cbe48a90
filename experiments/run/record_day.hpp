#pragma once

#include "agents/protocol/tick_record.hpp"
#include "experiments/metrics/day_result.hpp"
#include "experiments/record/run_record.hpp"
#include "experiments/run/day_door.hpp"
#include "experiments/scenario/scenario.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// How a day is played. None of it changes what happens in the day but what is asked for through the door.
struct Stage {
  std::string transport;                                ///< "dds" or "inproc"
  std::function<void(const TickRecord&)> on_tick = {};  ///< is told of each tick that is over, if there is one
  std::optional<DoorOptions> door = {};                 ///< whether the day takes requests while it goes on
};

/// The transport that takes least: "inproc", or the scenario's if the plans are made by another coordinator than
/// evbal's, which may know no other.
std::string own_transport(const Scenario& scenario);

/// The scenario for one of its controllers.
Scenario with_controller(Scenario scenario, const std::string& controller);

/// The same day without faults, with which the one with faults is compared, by own_transport.
Scenario without_faults(Scenario scenario);

/// Throws Error{bad_input} if the day cannot be planned: there is no model, it does not fit city, clock or horizon, or
/// there is no program of another coordinator's name.
void check_planning(const Scenario& scenario);

/// Plays the day under the scenario's controller and records it in `folder`, which must not exist or be empty;
/// `resolved` is the scenario's text for the record. Throws Error{run_failed} if the run breaks off, which leaves a
/// record marked as incomplete.
RunResult record_day(const Scenario& scenario, const std::string& resolved, const std::filesystem::path& folder,
                     const Stage& stage);

/// What the ticks of a whole day of the scenario came to.
DayResult result_of(const Scenario& scenario, const std::vector<TickRecord>& ticks);

/// Plays the day in this process without a record, and gives its result. Throws Error{run_failed}.
DayResult play_day(const Scenario& scenario);

/// The same by the scenario's transport, whose processes work in `folder`, which is made and removed again.
DayResult play_day(const Scenario& scenario, const std::filesystem::path& folder);

}  // namespace evbal

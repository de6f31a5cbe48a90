#pragma once

#include "agents/protocol/tick_record.hpp"
#include "experiments/run/day_door.hpp"
#include "experiments/run/twins.hpp"
#include "experiments/scenario/scenario.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// What the console's page is told, as JSON (page/console.js reads it).
namespace evbal {

/// What does not change during a day: scenario, clock, regions and their outlines, types of faults, and the faults that
/// the schedule has from the start.
std::string day_json(const Scenario& scenario, const std::filesystem::path& folder);

/// A fault of the schedule, at its position.
std::string fault_json(int position, const Fault& fault);

/// A tick that is over: by region what is there, the plan, what faults did, who wrote, and `events` for the log.
std::string tick_json(const TickRecord& record, const DayTally& so_far, const std::vector<Incident>& events);

/// How the day goes on.
std::string pace_json(const DayPace& pace);

/// What the day without faults has come to, by tick.
std::string tally_json(const DayTally& tally);

}  // namespace evbal

#pragma once

#include "agents/protocol/message_check.hpp"
#include "agents/world/city.hpp"
#include "common/clock.hpp"
#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace evbal {

/// How recorded counts become passengers.
enum class DemandModel {
  recorded,  ///< as many as on record, minutes drawn within the step
  poisson,   ///< Poisson around the record
};

/// Everything that the plants of one run share. Owned by the process; the plants point to it.
struct World {
  City city;                                   ///< with the scenario's overrides applied
  DemandDay day;                               ///< that is played
  DemandModel demand = DemandModel::recorded;  ///< how counts become passengers
  DayClock clock;                              ///< hours, tick, step and plan_every
  std::uint64_t seed = 0;                      ///< of all that is drawn
};

/// What bounds the messages of a run in this world.
MessageBounds bounds_of(const World& world);

/// Makes the processes that this one starts look for packs in the same folders: sets EVBAL_CITIES, which lists them
/// with colons. To be called before there are threads.
void share_pack_folders();

/// Names of the packs in the folders where packs are looked for, sorted.
std::vector<std::string> pack_names();

/// The city that a command line names: a shipped pack, else a folder. Throws Error{bad_input}.
City find_city(const std::string& name);

/// Reads the world's keys of a scenario: city, day, seed, demand, clock, fleet, charging, passengers, stations. `city`
/// is the name of a shipped pack or a path, relative to the scenario's file; what is given under fleet, charging,
/// passengers and stations replaces that field of the pack. Throws Error{bad_input} with file, line and reason.
World read_world(YamlMap& scenario);

/// Writes the same keys, every one of them explicit: read_world gives the same world back.
void write_world(YamlWriter& yaml, const World& world);

}  // namespace evbal

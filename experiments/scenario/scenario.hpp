#pragma once

#include "agents/world/world.hpp"
#include "coordinator/planning/settings.hpp"
#include "experiments/scenario/bus_security.hpp"
#include "experiments/scenario/expect.hpp"
#include "experiments/scenario/hosts.hpp"
#include "experiments/scenario/network_conditions.hpp"
#include "faults/schedule/schedule.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What is run (docs/scenarios.md): one YAML file, read once by the launcher and handed to every process as resolved.
namespace evbal {

/// Which plans `ipopt` solves too once the day is over, for a second opinion on the engine that made them.
enum class CrossCheck {
  off,    ///< none
  first,  ///< the first one
  every,  ///< all of them
};

/// A scenario as read: nothing is left to chance or to defaults.
struct Scenario {
  std::string name;                      ///< of the scenario
  World world;                           ///< city, day, clock, fleet
  PlanningSettings planning;             ///< its controller is the first of `controllers`
  std::vector<std::string> controllers;  ///< each makes a run of its own; at least one
  Schedule schedule;                     ///< of faults, drawn
  std::vector<Schedule> draws{
      Schedule{}};              ///< of the faults, as many as the schedule's `runs`; `schedule` is the first
  std::string transport;        ///< "dds" or "inproc"
  int regions_per_process = 1;  ///< regions that one evbal-agent hosts
  std::optional<NetworkConditions> network{};  ///< on the bus, below DDS
  std::vector<HostSpec> hosts{};               ///< of the regions over the bus; empty: the machine of the launcher
  std::filesystem::path dds_profiles{};        ///< XML file of Fast DDS for the bus; empty: none
  std::optional<BusSecurity> security{};       ///< on the bus, if there is one
  std::vector<Expect> expect;                  ///< what shall hold of the result
  CrossCheck cross_check = CrossCheck::off;    ///< none of what happens depends on it
};

/// What the command line says in place of the scenario.
struct Overrides {
  std::optional<std::string> controller{};              ///< in place of `controllers`
  std::optional<Command> coordinator{};                 ///< in place of `coordinator`
  std::optional<std::string> day{};                     ///< in place of `day`
  std::optional<std::uint64_t> seed{};                  ///< in place of `seed`
  std::optional<std::filesystem::path> faults{};        ///< a schedule file, or the name of one that is
                                                        ///< shipped; its `expect` adds to the scenario's
  std::optional<std::string> transport{};               ///< in place of `transport`
  std::optional<int> regions_per_process{};             ///< in place of `regions_per_process`
  std::optional<std::string> engine{};                  ///< in place of `engine`
  std::optional<std::filesystem::path> dds_profiles{};  ///< in place of `dds_profiles`
  std::vector<std::string> settings{};                  ///< KEY=VALUE, such as `balancing.tau=2`: in place of what the
                                                        ///< file says, and behind all of the above
};

/// The scenario file that a command line names: a path, or the name of one that is shipped, such as toy.yaml.
std::filesystem::path find_scenario(const std::filesystem::path& given);

/// The file's text with settings, each KEY=VALUE, in place of what it says. Throws Error{bad_input}.
YamlValue with_settings(YamlValue scenario, const std::vector<std::string>& settings);

/// Regions that one agent hosts if a scenario does not say: so many that there are at most 100 agents.
int usual_regions_per_process(int regions);

/// Reads a scenario, resolved or not. Throws Error{bad_input} with file, line, reason and what would be right; for an
/// override the option stands in place of the file.
Scenario read_scenario(const std::filesystem::path& file, const Overrides& overrides = {});

/// The same from a file that is loaded, perhaps with settings in place of its own (YamlValue::with).
Scenario read_scenario(const YamlValue& yaml, const Overrides& overrides = {});

/// What the scenario's schedules may refer to.
FaultContext fault_context(const Scenario& scenario);

/// The run of one controller with everything explicit, as YAML: read_scenario gives it back, and the processes read
/// their own keys from it by read_world, read_planning and read_resolved.
std::string resolved_yaml(const Scenario& scenario, const std::string& controller);

}  // namespace evbal

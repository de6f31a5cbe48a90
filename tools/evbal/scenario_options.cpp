#include "tools/evbal/scenario_options.hpp"

#include "coordinator/convex/engine.hpp"
#include "tools/evbal/usage_error.hpp"

#include <CLI/CLI.hpp>

#include <iterator>
#include <sstream>

namespace evbal {
namespace {

/// The words of a command line that is taken from the current directory.
Command words_of(const std::string& text) {
  std::istringstream in(text);
  return command_from(std::filesystem::current_path(), {std::istream_iterator<std::string>(in), {}});
}

std::string seed_complaint(const std::string& text) {
  const bool whole = text.find_first_not_of("0123456789") == std::string::npos;
  return whole ? "" : "give a whole number from 0 to 2^64-1";
}

}  // namespace

void add_day_options(CLI::App& command, ScenarioOptions& options) {
  Overrides& overrides = options.overrides;
  command.add_option("SCENARIO", options.scenario, "Scenario file (YAML), or the name of a shipped one")->required();
  command
      .add_option("--set", overrides.settings, "Any key of the scenario, such as balancing.p_shortage=20; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--day", overrides.day, "Another day on record, such as 2008-06-04");
  command.add_option("--seed", overrides.seed, "Another seed")->check(seed_complaint);
  command.add_option("--faults", overrides.faults, "Another fault schedule (YAML), or the name of a shipped one");
}

void add_scenario_options(CLI::App& command, ScenarioOptions& options) {
  add_day_options(command, options);
  Overrides& overrides = options.overrides;
  command.add_option("--controller", overrides.controller, "One controller in place of the scenario's");
  command
      .add_option_function<std::string>(
          "--coordinator", [&overrides](const std::string& text) { overrides.coordinator = words_of(text); },
          "Program or library that makes the plans in place of evbal-coordinator, with its words")
      ->type_name("COMMAND");
  command
      .add_option("--transport", overrides.transport,
                  "dds: processes on a bus, which strangers cannot join with `--set security=on`; inproc: one process")
      ->check(one_of_words({"dds", "inproc"}));
  command.add_option("--regions-per-process", overrides.regions_per_process, "Regions that an agent hosts");
  command.add_option("--engine", overrides.engine, "Solver of the balancing problem")
      ->check(one_of_words(engine_names()));
  command.add_option("--dds-profiles", overrides.dds_profiles,
                     "Settings of Fast DDS for the bus (XML), of which none are taken from elsewhere");
}

}  // namespace evbal

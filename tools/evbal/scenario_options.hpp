#pragma once

#include "experiments/scenario/scenario.hpp"

#include <filesystem>

namespace CLI {
class App;
}

namespace evbal {

/// What commands on a scenario ask alike.
struct ScenarioOptions {
  std::filesystem::path scenario;  ///< as given
  Overrides overrides;             ///< of the command line
};

/// Adds SCENARIO to a command, and the options that stand in place of those keys that say which day it is.
void add_day_options(CLI::App& command, ScenarioOptions& options);

/// The same, and all other options that stand in place of keys.
void add_scenario_options(CLI::App& command, ScenarioOptions& options);

}  // namespace evbal

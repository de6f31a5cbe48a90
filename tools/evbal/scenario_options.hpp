#pragma once

#include "experiments/scenario/scenario.hpp"

#include <filesystem>

namespace CLI {
class App;
}

namespace evbal {

/// What `evbal run` and `evbal show` ask alike.
struct ScenarioOptions {
  std::filesystem::path scenario;  ///< as given
  Overrides overrides;             ///< of the command line
};

/// Adds SCENARIO to a command, and the options that stand in place of its keys.
void add_scenario_options(CLI::App& command, ScenarioOptions& options);

}  // namespace evbal

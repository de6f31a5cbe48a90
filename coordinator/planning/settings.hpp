#pragma once

#include "agents/city/city.hpp"
#include "common/yaml.hpp"
#include "coordinator/balancing/engine.hpp"
#include "coordinator/balancing/problem.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// The program that plans in place of evbal-coordinator, and its first words; empty if none does.
using Command = std::vector<std::string>;

/// `words` with a program that has a slash, and every further word that names a file, as absolute paths; relative ones
/// start at `base`. A program without a slash is left to be found when it is started.
Command command_from(const std::filesystem::path& base, Command words);

/// The words in one line, for messages.
std::string shown(const Command& command);

/// Who plans, with what, and how much work a plan may cost.
struct PlanningSettings {
  std::string controller = "robust";
  Command coordinator;
  EngineSettings engine;
  std::filesystem::path model;   ///< file that `evbal fit` wrote; empty: the one beside the city's pack
  bool innovation_test = false;  ///< whether sets are widened where recent forecast errors leave them
  BalancingParameters balancing;

  /// Whether the Coordinator is to be told the future.
  bool foresees() const { return controller == "oracle"; }
};

/// Reads the planning keys of a scenario: controller, coordinator, engine, iterations, model, innovation_test,
/// balancing. All may be left out; `model: pack`, the default, is the file beside the city's pack, another path is
/// relative to the scenario's file. `coordinator` stands in place of the scenario's. Throws Error{bad_input} with file,
/// line and reason.
PlanningSettings read_planning(YamlMap& scenario, const std::optional<Command>& coordinator = {});

/// Reads the name of a controller: one of evbal's own or, with a coordinator in place of evbal's, whatever that one
/// may know. Throws Error{bad_input}.
std::string read_controller(const YamlValue& value, const Command& coordinator);

/// What is wrong with `name` for a controller of somebody else's, and what would be right; empty if nothing is.
std::string name_complaint(const std::string& name);

/// The same keys as YAML text, every one of them explicit: read_planning gives the same settings back.
std::string planning_yaml(const PlanningSettings& settings);

/// The file with the model of `city` that these settings mean.
std::filesystem::path model_file(const PlanningSettings& settings, const City& city);

}  // namespace evbal

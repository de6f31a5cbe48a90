#pragma once

#include "agents/city/city.hpp"
#include "common/yaml.hpp"
#include "coordinator/balancing/engine.hpp"
#include "coordinator/balancing/problem.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// Who plans, with what, and how much work a plan may cost.
struct PlanningSettings {
  std::string controller = "robust";
  EngineSettings engine;
  std::filesystem::path model;  ///< file that `evbal fit` wrote; empty: the one beside the city's pack
  BalancingParameters balancing;

  /// Whether the Coordinator is to be told the future.
  bool foresees() const { return controller == "oracle"; }
};

/// Reads the planning keys of a scenario: controller, engine, iterations, model, balancing. All may be left out;
/// `model: pack`, the default, is the file beside the city's pack, another path is relative to the scenario's file.
/// Throws Error{bad_input} with file, line and reason.
PlanningSettings read_planning(YamlMap& scenario);

/// The same keys as YAML text, every one of them explicit: read_planning gives the same settings back.
std::string planning_yaml(const PlanningSettings& settings);

/// The file with the model of `city` that these settings mean.
std::filesystem::path model_file(const PlanningSettings& settings, const City& city);

}  // namespace evbal

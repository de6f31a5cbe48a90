#pragma once

#include "agents/world/city.hpp"
#include "common/command.hpp"
#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/convex/engine.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace evbal {

/// Parameters of a controller of somebody else's, by name.
using ControllerParameters = std::map<std::string, std::variant<bool, double, std::string>>;

/// What is done about sensors that lie within what is possible (coordinator/filter).
enum class SensorFaults : std::uint8_t {
  ignore = 0,   ///< nothing: what can be true is believed
  flag = 1,     ///< plans name the fields that lie
  isolate = 2,  ///< and are made from estimates in their place
};

/// Who plans, with what, and how much work a plan may cost.
struct PlanningSettings {
  std::string controller = "robust";  ///< its name
  Command coordinator;                ///< command that plans in place of evbal-coordinator; empty: none
  ControllerParameters parameters;    ///< that the coordinator hands to its controller
  EngineSettings engine;              ///< which, and its limits
  std::filesystem::path model;        ///< file that `evbal fit` wrote; empty: the one beside the city's pack
  bool innovation_test = false;       ///< whether sets are inflated where recent forecast errors leave them
  SensorFaults sensor_faults = SensorFaults::ignore;  ///< what is done about them
  BalancingParameters balancing;                      ///< prices and bounds of the problem
};

/// Reads the planning keys of a scenario: controller, coordinator, parameters, engine, iterations, model,
/// innovation_test, sensor_faults, balancing. All may be left out; `model: pack`, the default, is the file beside the
/// city's pack, another path is relative to the scenario's file. `coordinator`, if it is given, stands in place of the
/// scenario's; an empty one has no parameters either. Throws Error{bad_input} with file, line and reason.
PlanningSettings read_planning(YamlMap& scenario, const std::optional<Command>& coordinator = {});

/// Reads the command of a coordinator, a list of words; paths are relative to the file. Throws Error{bad_input}.
Command read_command(const YamlValue& value);

/// Reads the name of a controller: one of evbal's own or, with a coordinator in place of evbal's, whatever that one
/// may know. Throws Error{bad_input}.
std::string read_controller(const YamlValue& value, const Command& coordinator);

/// What is wrong with `name` for a controller of somebody else's, and what would be right; empty if nothing is.
std::string validate_controller_name(const std::string& name);

/// Writes the same keys, every one of them explicit: read_planning gives the same settings back.
void write_planning(YamlWriter& yaml, const PlanningSettings& settings);

/// The file with the model of `city` that these settings mean.
std::filesystem::path model_file(const PlanningSettings& settings, const City& city);

}  // namespace evbal

#include "coordinator/planning/settings.hpp"

#include "coordinator/balancing/controllers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace evbal {
namespace {

const std::string own_model = "pack";

struct Price {
  const char* key;
  double BalancingParameters::*field;
  double low;
  double high;
};
constexpr std::array<Price, 20> prices{{
    {"a", &BalancingParameters::a, 1e-3, 2.0},
    {"theta_0", &BalancingParameters::theta_0, 0.0, 1e6},
    {"eps", &BalancingParameters::eps, 1e-3, 1e3},
    {"beta", &BalancingParameters::beta, 0.0, 1e3},
    {"omega", &BalancingParameters::omega, 0.0, 1e6},
    {"pi_e", &BalancingParameters::pi_e, 0.0, 1e6},
    {"p_shortage", &BalancingParameters::p_shortage, 0.0, 1e6},
    {"p_surplus", &BalancingParameters::p_surplus, 0.0, 1e6},
    {"p_ratio", &BalancingParameters::p_ratio, 0.0, 1e6},
    {"p_flow", &BalancingParameters::p_flow, 0.0, 1e6},
    {"eta", &BalancingParameters::eta, 0.0, 0.99},
    {"top_up", &BalancingParameters::top_up, 0.0, 1e3},
    {"m1", &BalancingParameters::m1, 0.0, 1e4},
    {"m2", &BalancingParameters::m2, 0.0, 1e4},
    {"flow_m1", &BalancingParameters::flow_m1, 0.0, 1e4},
    {"flow_end", &BalancingParameters::flow_end, 0.0, 1.0},
    {"flow_patience", &BalancingParameters::flow_patience, 0.0, 60.0},
    {"flow_served", &BalancingParameters::flow_served, 0.0, 1.0},
    {"flow_pickup", &BalancingParameters::flow_pickup, 0.0, 60.0},
    {"flow_value", &BalancingParameters::flow_value, 0.0, 1.0},
}};

struct Count {
  const char* key;
  int BalancingParameters::*field;
  int low;
  int high;
};
constexpr std::array<Count, 6> counts{{
    {"neighbours", &BalancingParameters::neighbours, 1, 10000},
    {"tau", &BalancingParameters::tau, 1, 48},
    {"flow_slot", &BalancingParameters::flow_slot, 1, 60},
    {"flow_slots", &BalancingParameters::flow_slots, 1, 60},
    {"flow_sends", &BalancingParameters::flow_sends, 1, 60},
    {"flow_neighbours", &BalancingParameters::flow_neighbours, 1, 10000},
}};

const std::vector<std::string> supplies = {"completions", "points"};   // by Supply
const std::vector<std::string> cures = {"ignore", "flag", "isolate"};  // by SensorFaults

BalancingParameters read_balancing(const YamlValue& value) {
  BalancingParameters out;
  YamlMap map(value);
  for (const Price& price : prices) {
    if (const auto given = map.find(price.key)) {
      out.*price.field = given->number(price.low, price.high);
    }
  }
  for (const Count& count : counts) {
    if (const auto given = map.find(count.key)) {
      out.*count.field = given->integer(count.low, count.high);
    }
  }
  if (const auto supply = map.find("supply")) {
    out.supply = static_cast<Supply>(supply->one_of(supplies));
  }
  map.finish();
  return out;
}

std::filesystem::path model_path(const YamlValue& value) {
  if (value.text() == own_model) {
    return {};
  }
  const std::filesystem::path given = value.text();
  return given.is_absolute() ? given : std::filesystem::path(value.file()).parent_path() / given;
}

std::variant<bool, double, std::string> read_parameter(const YamlValue& value) {
  const std::string text = value.text();
  if (text == "true" || text == "false") {
    return text == "true";
  }
  double number = 0.0;
  const char* const last = text.data() + text.size();
  const auto [end, failed] = std::from_chars(text.data(), last, number);
  if (failed == std::errc{} && end == last && std::isfinite(number)) {
    return number;
  }
  return text;
}

ControllerParameters read_parameters(const YamlValue& value) {
  ControllerParameters parameters;
  YamlMap map(value);
  for (const auto& name : map.keys()) {
    const YamlValue given = map.require(name);
    if (const auto wrong = validate_controller_name(name); !wrong.empty()) {
      throw given.error("parameter `" + name + "`: use 1 to 100 letters, digits, `-` and `_`");
    }
    parameters[name] = read_parameter(given);
  }
  return parameters;
}

void write_parameters(YamlWriter& yaml, const ControllerParameters& parameters) {
  yaml.key("parameters").begin_map();
  for (const auto& [name, value] : parameters) {
    yaml.key(name);
    if (const auto* const number = std::get_if<double>(&value)) {
      yaml.number(*number);
    } else if (const auto* const text = std::get_if<std::string>(&value)) {
      yaml.text(*text);
    } else {
      yaml.boolean(std::get<bool>(value));
    }
  }
  yaml.end_map();
}

}  // namespace

std::string validate_controller_name(const std::string& name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  constexpr std::size_t longest = 100;  // directories are named after it
  return !name.empty() && name.size() <= longest && std::ranges::all_of(name, fits)
             ? ""
             : "`" + name + "` is no name for a controller; use 1 to 100 letters, digits, `-` and `_`";
}

Command read_command(const YamlValue& value) {
  Command words;
  for (const auto& item : value.items()) {
    words.push_back(item.text());
  }
  return command_from(std::filesystem::path(value.file()).parent_path(), std::move(words));
}

std::string read_controller(const YamlValue& value, const Command& coordinator) {
  if (coordinator.empty()) {
    return controller_names()[value.one_of(controller_names())];
  }
  if (const auto wrong = validate_controller_name(value.text()); !wrong.empty()) {
    throw value.error(wrong);
  }
  return value.text();
}

PlanningSettings read_planning(YamlMap& scenario, const std::optional<Command>& coordinator) {
  PlanningSettings out;
  const auto command = scenario.find("coordinator");
  const Command given = command ? read_command(*command) : Command{};
  out.coordinator = coordinator.value_or(given);
  if (const auto parameters = scenario.find("parameters")) {
    if (out.coordinator.empty() && !coordinator) {
      throw parameters->error("`parameters` are of a `coordinator`; those of evbal's controllers are `balancing`");
    }
    out.parameters = out.coordinator.empty() ? ControllerParameters{} : read_parameters(*parameters);
  }
  if (const auto controller = scenario.find("controller")) {
    out.controller = read_controller(*controller, out.coordinator.empty() ? given : out.coordinator);
  }
  if (const auto engine = scenario.find("engine")) {
    out.engine.name = engine_names()[engine->one_of(engine_names())];
  }
  if (const auto iterations = scenario.find("iterations")) {
    out.engine.max_iterations = iterations->integer(1, 1000000);
  }
  if (const auto model = scenario.find("model")) {
    out.model = model_path(*model);
  }
  if (const auto test = scenario.find("innovation_test")) {
    out.innovation_test = test->boolean();
  }
  if (const auto cure = scenario.find("sensor_faults")) {
    out.sensor_faults = static_cast<SensorFaults>(cure->one_of(cures));
  }
  if (const auto balancing = scenario.find("balancing")) {
    out.balancing = read_balancing(*balancing);
  }
  return out;
}

void write_planning(YamlWriter& yaml, const PlanningSettings& settings) {
  yaml.key("controller").word(settings.controller).key("coordinator").begin_list(YamlWriter::Layout::one_line);
  for (const auto& word : settings.coordinator) {
    yaml.text(word);
  }
  yaml.end_list();
  if (!settings.coordinator.empty()) {
    write_parameters(yaml, settings.parameters);
  }
  yaml.key("engine").word(settings.engine.name);
  yaml.key("iterations").number(settings.engine.max_iterations).key("model");
  if (settings.model.empty()) {
    yaml.word(own_model);
  } else {
    yaml.text(std::filesystem::absolute(settings.model).string());
  }
  yaml.key("innovation_test").boolean(settings.innovation_test);
  yaml.key("sensor_faults").word(cures[static_cast<std::size_t>(settings.sensor_faults)]);
  yaml.key("balancing").begin_map();
  for (const Price& price : prices) {
    yaml.key(price.key).number(settings.balancing.*price.field);
  }
  for (const Count& count : counts) {
    yaml.key(count.key).number(settings.balancing.*count.field);
  }
  yaml.key("supply").word(supplies[static_cast<std::size_t>(settings.balancing.supply)]).end_map();
}

std::filesystem::path model_file(const PlanningSettings& settings, const City& city) {
  return settings.model.empty() ? city.folder / "model.json" : settings.model;
}

}  // namespace evbal

#include "coordinator/planning/settings.hpp"

#include "coordinator/balancing/controllers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
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
constexpr std::array<Price, 12> prices{{
    {"a", &BalancingParameters::a, 1e-3, 2.0},
    {"theta_0", &BalancingParameters::theta_0, 0.0, 1e6},
    {"eps", &BalancingParameters::eps, 1e-3, 1e3},
    {"beta", &BalancingParameters::beta, 0.0, 1e3},
    {"omega", &BalancingParameters::omega, 0.0, 1e6},
    {"pi_e", &BalancingParameters::pi_e, 0.0, 1e6},
    {"p_shortage", &BalancingParameters::p_shortage, 0.0, 1e6},
    {"p_surplus", &BalancingParameters::p_surplus, 0.0, 1e6},
    {"p_ratio", &BalancingParameters::p_ratio, 0.0, 1e6},
    {"eta", &BalancingParameters::eta, 0.0, 0.99},
    {"m1", &BalancingParameters::m1, 0.0, 1e4},
    {"m2", &BalancingParameters::m2, 0.0, 1e4},
}};

struct Count {
  const char* key;
  int BalancingParameters::*field;
  int low;
  int high;
};
constexpr std::array<Count, 2> counts{{
    {"neighbours", &BalancingParameters::neighbours, 1, 10000},
    {"tau", &BalancingParameters::tau, 1, 48},
}};

const std::vector<std::string> supplies = {"completions", "points"};  // by Supply

std::string shortest(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

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

Command read_command(const YamlValue& value) {
  Command words;
  for (const auto& item : value.items()) {
    words.push_back(item.text());
  }
  return command_from(std::filesystem::path(value.file()).parent_path(), std::move(words));
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    out += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  }
  return out + "\"";
}

}  // namespace

std::string name_complaint(const std::string& name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  return !name.empty() && std::ranges::all_of(name, fits)
             ? ""
             : "`" + name + "` is no name for a controller; use letters, digits, `-` and `_`";
}

std::string read_controller(const YamlValue& value, const Command& coordinator) {
  if (coordinator.empty()) {
    return controller_names()[value.one_of(controller_names())];
  }
  if (const auto complaint = name_complaint(value.text()); !complaint.empty()) {
    throw value.error(complaint);
  }
  return value.text();
}

PlanningSettings read_planning(YamlMap& scenario, const std::optional<Command>& coordinator) {
  PlanningSettings out;
  if (const auto command = scenario.find("coordinator")) {
    out.coordinator = read_command(*command);
  }
  out.coordinator = coordinator.value_or(out.coordinator);
  if (const auto controller = scenario.find("controller")) {
    out.controller = read_controller(*controller, out.coordinator);
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
  if (const auto balancing = scenario.find("balancing")) {
    out.balancing = read_balancing(*balancing);
  }
  return out;
}

std::string planning_yaml(const PlanningSettings& settings) {
  const std::string model =
      settings.model.empty() ? own_model : quoted(std::filesystem::absolute(settings.model).string());
  std::string command;
  for (const auto& word : settings.coordinator) {
    command += (command.empty() ? "" : ", ") + quoted(word);
  }
  std::string text = "controller: " + settings.controller + "\ncoordinator: [" + command +
                     "]\nengine: " + settings.engine.name +
                     "\niterations: " + std::to_string(settings.engine.max_iterations) + "\nmodel: " + model +
                     "\ninnovation_test: " + (settings.innovation_test ? "true" : "false") + "\nbalancing:\n";
  for (const Price& price : prices) {
    text += std::string("  ") + price.key + ": " + shortest(settings.balancing.*price.field) + "\n";
  }
  for (const Count& count : counts) {
    text += std::string("  ") + count.key + ": " + std::to_string(settings.balancing.*count.field) + "\n";
  }
  text += "  supply: " + supplies[static_cast<std::size_t>(settings.balancing.supply)] + "\n";
  return text;
}

std::filesystem::path model_file(const PlanningSettings& settings, const City& city) {
  return settings.model.empty() ? city.folder / "model.json" : settings.model;
}

}  // namespace evbal

#include "experiments/scenario/scenario.hpp"

#include "common/installation.hpp"
#include "common/plain_text.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "coordinator/convex/engine.hpp"

#include <algorithm>

namespace evbal {
namespace {

const std::vector<std::string> transports = {"dds", "inproc"};
const std::vector<std::string> cross_checks = {"off", "ipopt", "every"};  // by CrossCheck

std::vector<std::string> read_controllers(YamlMap& map, const PlanningSettings& planning) {
  const auto list = map.find("controllers");
  if (!list) {
    return {planning.controller};
  }
  if (map.find("controller")) {
    throw list->error("`controller` and `controllers` are both given; keep one");
  }
  const auto command = map.find("coordinator");
  const Command knows = planning.coordinator.empty() && command ? read_command(*command) : planning.coordinator;
  std::vector<std::string> controllers;
  for (const auto& item : list->items()) {
    controllers.push_back(read_controller(item, knows));
    if (std::count(controllers.begin(), controllers.end(), item.text()) > 1) {
      throw item.error("controller `" + item.text() + "` is given twice");
    }
  }
  if (controllers.empty()) {
    throw list->error("names no controller; give at least one");
  }
  return controllers;
}

/// The schedule of an own file in place of the scenario's.
void read_fault_file(const std::filesystem::path& file, const FaultContext& context, Scenario& scenario) {
  YamlMap map(YamlValue::load(find_shipped("faults", file)));
  scenario.draws = read_schedules(map, context);
  if (const auto expect = map.find("expect")) {
    const auto more = read_expect(*expect);
    scenario.expect.insert(scenario.expect.end(), more.begin(), more.end());
  }
  map.finish();
}

void read_faults(YamlMap& scenario_map, const std::optional<std::filesystem::path>& file, Scenario& scenario) {
  const FaultContext context = fault_context(scenario);
  const auto own = scenario_map.find("faults");
  if (file) {
    read_fault_file(*file, context, scenario);
  } else if (own) {
    YamlMap map(*own);
    scenario.draws = read_schedules(map, context);
    map.finish();
  }
}

/// A word of the command line that must be one of `words`.
std::string known_word(const std::string& option, const std::string& word, const std::vector<std::string>& words) {
  if (const auto wrong = validate_word(word, words); !wrong.empty()) {
    throw bad_input(option + ": " + wrong);
  }
  return word;
}

/// A controller of the command line: one of evbal's or, with another coordinator, any that may have a name.
std::string own_or_known(const std::string& option, const std::string& name, const Command& coordinator) {
  if (coordinator.empty()) {
    return known_word(option, name, controller_names());
  }
  if (const auto wrong = validate_controller_name(name); !wrong.empty()) {
    throw bad_input(option + ": " + wrong);
  }
  return name;
}

void apply(const Overrides& overrides, Scenario& scenario) {
  if (overrides.controller) {
    scenario.controllers = {own_or_known("--controller", *overrides.controller, scenario.planning.coordinator)};
  }
  if (overrides.engine) {
    scenario.planning.engine.name = known_word("--engine", *overrides.engine, engine_names());
  }
  if (overrides.transport) {
    scenario.transport = known_word("--transport", *overrides.transport, transports);
  }
  if (overrides.day) {
    const std::string day = known_word("--day", *overrides.day, scenario.world.city.days);
    scenario.world.day = read_demand(scenario.world.city, day);
  }
  if (overrides.dds_profiles) {
    scenario.dds_profiles = std::filesystem::absolute(*overrides.dds_profiles);
  }
  scenario.world.seed = overrides.seed.value_or(scenario.world.seed);
}

/// What acts on the bus is given for a run over the bus only, and a network of the run's own on one host only.
void check_transport(const Scenario& scenario) {
  if (scenario.network && !scenario.hosts.empty()) {
    throw bad_input("network: is of the run's own on one host, and there are `hosts`; leave one of them out");
  }
  const auto needs_bus = [&](bool given, const std::string& what) {
    if (given && scenario.transport != "dds") {
      throw bad_input(what + " the bus; with transport `" + scenario.transport + "` there is none, choose `dds`");
    }
  };
  needs_bus(scenario.network.has_value(), "network: acts on");
  needs_bus(!scenario.dds_profiles.empty(), "dds_profiles: are of");
}

int read_regions_per_process(YamlMap& map, const Overrides& overrides, int regions) {
  const auto given = map.find("regions_per_process");
  const int of_file = given ? given->integer(1, 1'000'000) : usual_regions_per_process(regions);
  if (overrides.regions_per_process.value_or(1) < 1) {
    throw bad_input("--regions-per-process: must be at least 1");
  }
  return overrides.regions_per_process.value_or(of_file);
}

/// The name that the file gives, else the file's own.
std::string read_name(YamlMap& map) {
  if (const auto name = map.find("name")) {
    return name->file_name();
  }
  const std::string& file = map.value().file();
  std::string name = std::filesystem::path(file).stem().string();
  if (const auto complaint = validate_file_name(name); !complaint.empty()) {
    throw bad_input(file, 0, "the file's name, which the scenario takes for want of `name`, " + complaint);
  }
  return name;
}

}  // namespace

std::filesystem::path find_scenario(const std::filesystem::path& given) {
  return find_shipped("scenarios", given);
}

YamlValue with_settings(YamlValue scenario, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw bad_input("--set: `" + setting + "` is no setting; write KEY=VALUE, such as balancing.p_shortage=20");
    }
    const std::string key = setting.substr(0, equals);
    scenario = scenario.with(key, YamlValue::parse_option(setting.substr(equals + 1), "--set " + key));
  }
  return scenario;
}

int usual_regions_per_process(int regions) {
  constexpr int most_agents = 100;
  return (regions + most_agents - 1) / most_agents;
}

Scenario read_scenario(const std::filesystem::path& file, const Overrides& overrides) {
  return read_scenario(YamlValue::load(file), overrides);
}

Scenario read_scenario(const YamlValue& yaml, const Overrides& overrides) {
  YamlMap map(with_settings(yaml, overrides.settings));
  map.require("schema").integer(1, 1);
  Scenario scenario;
  scenario.name = read_name(map);
  scenario.world = read_world(map);
  scenario.planning = read_planning(map, overrides.coordinator);
  scenario.controllers = read_controllers(map, scenario.planning);
  const auto transport = map.find("transport");
  scenario.transport = transport ? transports[transport->one_of(transports)] : transports.front();
  scenario.regions_per_process = read_regions_per_process(map, overrides, scenario.world.city.size());
  if (const auto network = map.find("network")) {
    scenario.network = read_network(*network);
  }
  if (const auto hosts = map.find("hosts")) {
    scenario.hosts = read_hosts(*hosts);
  }
  if (const auto profiles = map.find("dds_profiles")) {
    scenario.dds_profiles = std::filesystem::absolute(profiles->file()).parent_path() / profiles->text();
  }
  if (const auto security = map.find("security")) {
    scenario.security = read_security(*security);
  }
  if (const auto expect = map.find("expect")) {
    scenario.expect = read_expect(*expect);
  }
  if (const auto check = map.find("cross_check")) {
    scenario.cross_check = static_cast<CrossCheck>(check->one_of(cross_checks));
  }
  read_faults(map, overrides.faults, scenario);
  scenario.schedule = scenario.draws.front();
  map.finish();
  apply(overrides, scenario);
  check_transport(scenario);
  scenario.planning.controller = scenario.controllers.front();
  return scenario;
}

FaultContext fault_context(const Scenario& scenario) {
  const Eigen::VectorXi points = scenario.world.city.points();
  return {scenario.world.clock,
          {points.begin(), points.end()},
          regions_by_host(scenario.hosts, static_cast<int>(points.size()), scenario.regions_per_process)};
}

std::string resolved_yaml(const Scenario& scenario, const std::string& controller) {
  PlanningSettings planning = scenario.planning;
  planning.controller = controller;
  YamlWriter yaml;
  yaml.key("schema").number(1).key("name").text(scenario.name);
  write_world(yaml, scenario.world);
  write_planning(yaml, planning);
  yaml.key("cross_check").word(cross_checks[static_cast<std::size_t>(scenario.cross_check)]);
  yaml.key("transport").word(scenario.transport).key("regions_per_process").number(scenario.regions_per_process);
  if (scenario.network) {
    yaml.key("network");
    write_network(yaml, *scenario.network);
  }
  if (!scenario.hosts.empty() && scenario.transport == "dds") {
    yaml.key("hosts");
    write_hosts(yaml, scenario.hosts);
  }
  if (!scenario.dds_profiles.empty()) {
    yaml.key("dds_profiles").text(scenario.dds_profiles.string());
  }
  if (scenario.security) {
    yaml.key("security");
    write_security(yaml, *scenario.security);
  }
  yaml.key("faults").begin_map();
  write_schedule(yaml, scenario.schedule, scenario.world.clock);
  yaml.end_map().key("expect").begin_list();
  for (const auto& expect : scenario.expect) {
    write_expect(yaml, expect);
  }
  return yaml.end_list().finish();
}

}  // namespace evbal

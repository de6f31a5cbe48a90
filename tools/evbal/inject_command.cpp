#include "tools/evbal/inject_command.hpp"

#include "common/error.hpp"
#include "common/suggestion.hpp"
#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"
#include "experiments/run/request_box.hpp"
#include "faults/schedule/fault_types.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr auto patience = 60s;  // a tick of the largest city takes some seconds

/// As the command line has it; what is empty was not given.
struct InjectArguments {
  std::string run;
  std::string type;
  std::string name;
  std::vector<std::string> regions;
  std::vector<std::string> agents;
  bool coordinator = false;
  bool injector = false;
  std::string field;
  std::string topic;
  std::string duration;
  std::string magnitude;
  std::string ramp;
  std::string to;
  std::string on_start;
  bool invisible = false;
};

void write_list(YamlWriter& yaml, const char* key, const std::vector<std::string>& words) {
  if (words.empty()) {
    return;
  }
  yaml.key(key).begin_list();
  for (const std::string& word : words) {
    yaml.value(YamlValue::parse_option(word, std::string("--") + key));
  }
  yaml.end_list();
}

/// What was given for `option`, as a schedule writes it.
void write_given(YamlWriter& yaml, const std::string& key, const std::string& option, const std::string& text) {
  if (!text.empty()) {
    yaml.key(key).value(YamlValue::parse_option(text, option));
  }
}

void write_target(YamlWriter& yaml, const InjectArguments& arguments) {
  yaml.key("target").begin_map();
  write_list(yaml, "regions", arguments.regions);
  write_list(yaml, "agents", arguments.agents);
  if (arguments.coordinator) {
    yaml.key("coordinator").boolean(true);
  }
  if (arguments.injector) {
    yaml.key("injector").boolean(true);
  }
  write_given(yaml, "field", "--field", arguments.field);
  write_given(yaml, "topic", "--topic", arguments.topic);
  yaml.end_map();
}

/// A count alone, such as 3, is of what the type counts; of charging points all are meant if nothing is given.
void write_magnitude(YamlWriter& yaml, const FaultType& type, const std::string& text) {
  if (type.counts_points() && text.empty()) {
    yaml.key(type.magnitude).begin_map().key("fraction_of_points").number(1).end_map();
  } else if (type.unit == MagnitudeUnit::count && !text.empty() && text.front() != '{') {
    yaml.key(type.magnitude).begin_map();
    write_given(yaml, type.counted, "--magnitude", text);
    yaml.end_map();
  } else {
    write_given(yaml, type.magnitude, "--magnitude", text);
  }
}

/// The request, with the keys that a schedule has.
std::string request_of(const InjectArguments& arguments) {
  const auto names = fault_type_names();
  if (const auto wrong = validate_word(arguments.type, names); !wrong.empty()) {
    throw bad_input("FAULT: " + wrong);
  }
  const FaultType& type = fault_types()[std::ranges::find(names, arguments.type) - names.begin()];
  YamlWriter yaml;
  yaml.key("do").word("fault").key("fault").begin_map();
  write_given(yaml, "name", "--name", arguments.name);
  yaml.key("type").word(type.name);
  if (type.target != TargetKind::engine) {
    write_target(yaml, arguments);
  }
  write_given(yaml, type.duration, "--for", arguments.duration);
  write_magnitude(yaml, type, arguments.magnitude);
  write_given(yaml, "ramp", "--ramp", arguments.ramp);
  write_given(yaml, "to", "--to", arguments.to);
  write_given(yaml, "on_start", "--on-start", arguments.on_start);
  if (arguments.invisible) {
    yaml.key("visible").boolean(false);
  }
  yaml.end_map();
  return yaml.finish();
}

}  // namespace

void add_inject_command(CLI::App& app) {
  const auto arguments = std::make_shared<InjectArguments>();
  CLI::App* command = app.add_subcommand("inject", "Add a fault to a run while it plays its day");
  command->add_option("RUN", arguments->run, "Directory of the run")->required();
  command->add_option("FAULT", arguments->type, "Type of the fault, such as charger.outage (evbal list faults)")
      ->required();
  command->add_option("--regions", arguments->regions, "Regions that it acts on, such as 3,7")->delimiter(',');
  command->add_option("--agents", arguments->agents, "Agents that it acts on, by a region that they host")
      ->delimiter(',');
  command->add_flag("--coordinator", arguments->coordinator, "It acts on the coordinator");
  command->add_flag("--injector", arguments->injector, "It acts on the injector");
  command->add_option("--field", arguments->field, "Field of the reports that a sensor fault acts on, such as vacant");
  command->add_option("--topic", arguments->topic, "What a network fault acts on: report, plan or all");
  command->add_option("--for", arguments->duration, "How long it lasts, such as 30min")->required();
  command->add_option(
      "--magnitude", arguments->magnitude,
      "How much, as a schedule has it, such as 1.8, 10min or a number of points or vehicles; all points "
      "of a region if left out");
  command->add_option("--ramp", arguments->ramp, "Minutes of rise and of fall, such as 10min");
  command->add_option("--to", arguments->to, "Region where demand.shift sends passengers");
  command->add_option("--on-start", arguments->on_start, "Cars at points that fail: drain or evict");
  command->add_flag("--invisible", arguments->invisible, "Reports and forecasts do not show it");
  command->add_option("--name", arguments->name, "Name of the fault; otherwise by-hand-1, -2, ...");
  command->callback(
      [arguments] { std::printf("%s\n", ask_run(arguments->run, request_of(*arguments), patience).c_str()); });
}

}  // namespace evbal

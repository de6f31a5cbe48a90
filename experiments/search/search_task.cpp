#include "experiments/search/search_task.hpp"

#include "common/installation.hpp"
#include "common/suggestion.hpp"
#include "experiments/metrics/metrics.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace evbal {
namespace {

/// The map of a schedule: that of the command line, else the scenario's own.
YamlMap schedule_map(const YamlValue& scenario, const Overrides& overrides) {
  if (overrides.faults) {
    return YamlMap(YamlValue::load(find_shipped("faults", *overrides.faults)));
  }
  return YamlMap(YamlMap(scenario).require("faults"));
}

/// The scenario without its faults, which a search need not draw as they stand.
Scenario read_without_faults(const YamlValue& yaml, Overrides overrides) {
  overrides.faults.reset();
  overrides.settings.clear();
  const YamlValue none = YamlValue::parse("{schema: 1, faults: []}", "faults");
  Scenario scenario = read_scenario(yaml.with("faults", none), overrides);
  if (scenario.controllers.size() > 1) {
    throw bad_input(yaml.file(), 0,
                    "has several controllers, and each has its own worst faults; choose one by "
                    "--controller");
  }
  if (!scenario.planning.coordinator.empty()) {
    throw bad_input("coordinator `" + shown(scenario.planning.coordinator) +
                    "`: takes part over the bus, without which a search plays its days; leave it out");
  }
  return scenario;
}

std::optional<Expect> under_search(const Scenario& scenario) {
  std::optional<Expect> found;
  for (const auto& expect : scenario.expect) {
    if (expect.under_search && found) {
      throw bad_input("expect: `" + found->metric + "` and `" + expect.metric +
                      "` are both expected under search, which takes one; keep one");
    }
    found = expect.under_search ? expect : found;
  }
  return found;
}

bool more_is_better(const std::string& metric) {
  static const std::set<std::string> good = {"served", "completions", "passenger_km", "charged_kwh"};
  return good.contains(metric);
}

void choose_metric(const std::string& given, SearchTask& task) {
  const std::vector<std::string> known = metric_names();
  if (!given.empty() && std::find(known.begin(), known.end(), given) == known.end()) {
    throw bad_input("--metric: `" + given + "` is no metric" + did_you_mean(given, known));
  }
  if (!task.expect) {
    task.metric = given.empty() ? "lost" : given;
    task.more_is_worse = !more_is_better(task.metric);
    return;
  }
  if (!given.empty() && given != task.expect->metric) {
    throw bad_input("--metric: the scenario expects something of `" + task.expect->metric +
                    "` under search; leave --metric out");
  }
  task.metric = task.expect->metric;
  task.more_is_worse = task.expect->at_most;
}

}  // namespace

SearchTask read_search_task(const std::filesystem::path& file, const Overrides& overrides, const std::string& metric) {
  const YamlValue yaml = with_settings(YamlValue::load(file), overrides.settings);
  SearchTask task{.scenario = read_without_faults(yaml, overrides)};
  YamlMap schedule = schedule_map(yaml, overrides);
  task.ingredients = read_ingredients(schedule, fault_context(task.scenario));
  const auto more = overrides.faults ? schedule.find("expect") : std::nullopt;
  if (more) {
    const std::vector<Expect> expected = read_expect(*more);
    task.scenario.expect.insert(task.scenario.expect.end(), expected.begin(), expected.end());
  }
  schedule.finish();
  task.expect = under_search(task.scenario);
  choose_metric(metric, task);
  return task;
}

}  // namespace evbal

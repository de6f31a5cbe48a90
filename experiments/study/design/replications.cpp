#include "experiments/study/design/replications.hpp"

#include "common/contract.hpp"
#include "common/digest.hpp"
#include "experiments/study/design/study_file.hpp"
#include "experiments/study/design/variant_settings.hpp"

#include <algorithm>
#include <filesystem>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// `none`, `scenario`, a schedule's file, or a schedule.
std::optional<YamlValue> read_schedule_of(const YamlValue& value) {
  if (value.is_map()) {
    return value;
  }
  if (value.text() == "scenario") {
    return std::nullopt;
  }
  if (value.text() == "none") {
    return YamlValue::parse("{schema: 1, faults: []}", value.file());
  }
  return YamlValue::load(fs::path(value.file()).parent_path() / value.text());
}

/// A schedule's seed for one (day, seed) of the sweep.
YamlValue redrawn(const YamlValue& schedule, const std::string& day, std::uint64_t seed) {
  const auto own = YamlMap(schedule).find("seed");
  const std::string text = std::to_string(own ? own->seed() : 0) + " " + day + " " + std::to_string(seed);
  return YamlValue::parse(std::to_string(std::stoull(text_digest(text).substr(0, 16), nullptr, 16)), schedule.file());
}

YamlValue with_faults(const YamlValue& scenario, const std::optional<YamlValue>& given, const std::string& day,
                      std::uint64_t seed) {
  const auto schedule = given ? given : YamlMap(scenario).find("faults");
  if (!schedule) {
    return scenario;
  }
  return scenario.with("faults", *schedule).with("faults.seed", redrawn(*schedule, day, seed));
}

YamlValue scenario_beside(const YamlValue& name) {
  return YamlValue::load(fs::path(name.file()).parent_path() / name.text());
}

/// A scenario with `settings` in place of its own, by their paths.
YamlValue with_settings(YamlValue scenario, const YamlValue& settings) {
  YamlMap map(settings);
  for (const auto& path : map.keys()) {
    const YamlValue value = map.require(path);
    refuse_path(value, path);
    scenario = scenario.with(path, value);
  }
  return scenario;
}

std::vector<YamlValue> some_days(const std::optional<YamlValue>& days, const YamlValue& place) {
  if (!days) {
    throw place.error("has no days; give `days` here, or those of all scenarios beside `scenarios`");
  }
  return distinct_items(*days);
}

}  // namespace

Replications::Replications(YamlMap& map)
    : scenarios_(read_scenarios(map)),
      faults_(read_faults(map.find("faults"))),
      seeds_(read_seeds(map.require("seeds"))) {}

Replications::Scenario Replications::read_scenario_of(const std::string& name, const YamlValue& value,
                                                      const std::optional<YamlValue>& days) {
  if (!value.is_map()) {
    return {name, scenario_beside(value), some_days(days, value), {}};
  }
  YamlMap own(value);
  Scenario scenario{name, scenario_beside(own.require("file")), {}, {}};
  const auto own_days = own.find("days");
  scenario.days = some_days(own_days ? own_days : days, value);
  if (const auto settings = own.find("settings")) {
    scenario.yaml = with_settings(scenario.yaml, *settings);
  }
  scenario.tuned_as = own.find("tuned_as");
  own.finish();
  return scenario;
}

std::vector<Replications::Scenario> Replications::read_scenarios(YamlMap& map) {
  const auto several = map.find("scenarios");
  if (!several) {
    const YamlValue name = map.require("scenario");
    return {{fs::path(name.text()).stem().string(), scenario_beside(name), distinct_items(map.require("days")), {}}};
  }
  if (map.find("scenario")) {
    throw several->error("`scenario` and `scenarios` are both given; keep one");
  }
  const auto days = map.find("days");
  YamlMap names(*several);
  std::vector<Scenario> scenarios;
  for (const auto& name : names.keys()) {
    scenarios.push_back(read_scenario_of(name, names.require(name), days));
  }
  if (scenarios.empty()) {
    throw several->error("names no scenario; give at least one");
  }
  return scenarios;
}

std::vector<Replications::Faults> Replications::read_faults(const std::optional<YamlValue>& value) {
  if (!value) {
    return {{"", std::nullopt}};
  }
  std::vector<Faults> faults;
  YamlMap map(*value);
  for (const auto& name : map.keys()) {
    faults.push_back({name, read_schedule_of(map.require(name))});
  }
  if (faults.empty()) {
    throw value->error("names no schedule; leave `faults` out to have the scenario's own");
  }
  return faults;
}

void Replications::cut(std::size_t days, std::size_t seeds) {
  for (auto& scenario : scenarios_) {
    auto& own = scenario.days;
    own.erase(own.begin() + static_cast<std::ptrdiff_t>(std::min(days, own.size())), own.end());
  }
  seeds_.resize(std::min(seeds, seeds_.size()));
}

std::vector<std::string> Replications::scenarios() const {
  std::vector<std::string> names;
  names.reserve(scenarios_.size());
  for (const auto& scenario : scenarios_) {
    names.push_back(scenario.name);
  }
  return names;
}

const Replications::Scenario& Replications::scenario(const std::string& name) const {
  const auto found = std::find_if(scenarios_.begin(), scenarios_.end(), [&](const auto& s) { return s.name == name; });
  EVBAL_EXPECT(found != scenarios_.end(), "one of the file's scenarios");
  return *found;
}

const std::optional<YamlValue>& Replications::tuned_as(const std::string& name) const {
  return scenario(name).tuned_as;
}

const std::vector<YamlValue>& Replications::days_of(const std::string& name) const {
  return scenario(name).days;
}

std::vector<std::string> Replications::faults() const {
  std::vector<std::string> names;
  names.reserve(faults_.size());
  for (const auto& faults : faults_) {
    names.push_back(faults.name);
  }
  return names;
}

std::vector<PlannedReplication> Replications::of(const std::string& name,
                                                 const std::vector<std::uint64_t>& own_seeds) const {
  const Scenario& one = scenario(name);
  std::vector<PlannedReplication> replications;
  for (const auto& faults : faults_) {
    for (const auto& day : one.days) {
      for (const auto seed : own_seeds.empty() ? seeds_ : own_seeds) {
        const YamlValue seed_text = YamlValue::parse(std::to_string(seed), day.file());
        PlannedReplication replication{.scenario = name,
                                       .faults = faults.name,
                                       .day = day.text(),
                                       .seed = seed,
                                       .yaml = one.yaml.with("day", day).with("seed", seed_text)};
        replication.yaml = with_faults(replication.yaml, faults.schedule, replication.day, seed);
        replications.push_back(std::move(replication));
      }
    }
  }
  return replications;
}

}  // namespace evbal

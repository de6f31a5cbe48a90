#include "experiments/sweep/sweep.hpp"

#include "common/digest.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "experiments/metrics/metrics.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// A path with one of the values that it is to take.
struct Setting {
  std::string path;
  YamlValue value;
};

struct Variant {
  std::string name;
  std::string controller;
  std::vector<std::vector<Setting>> points;  ///< every combination of its settings
};

struct NamedFaults {
  std::string name;
  std::optional<YamlValue> schedule;  ///< none: the scenario's own, if it has any
};

/// As a name in files and on the command line.
std::string plain_name(const YamlValue& value) {
  std::string name = value.text();
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), plain)) {
    throw value.error("`" + name + "` is no name; write letters, digits, `-`, `_` and `.` only");
  }
  return name;
}

std::string shown(const YamlValue& value) {
  return value.is_scalar() ? value.text() : value.dump();
}

std::vector<YamlValue> distinct_items(const YamlValue& list) {
  std::set<std::string> seen;
  for (const auto& item : list.items()) {
    if (!seen.insert(shown(item)).second) {
      throw item.error("`" + shown(item) + "` is given twice");
    }
  }
  if (seen.empty()) {
    throw list.error("holds nothing; give at least one");
  }
  return list.items();
}

/// What a sweep says elsewhere is no setting too, and nor is what has no influence or would be a column twice.
void refuse_path(const YamlValue& value, const std::string& path) {
  static constexpr std::array own = {"schema",      "name",   "day",       "seed",   "controller",
                                     "controllers", "faults", "transport", "expect", "regions_per_process"};
  const std::vector<std::string> metrics = metric_names();
  if (std::find(own.begin(), own.end(), path.substr(0, path.find('.'))) != own.end() ||
      std::find(metrics.begin(), metrics.end(), path) != metrics.end()) {
    throw value.error("`" + path +
                      "` cannot be a setting of a variant; settings are keys of the scenario such as "
                      "`balancing.p_shortage` or `clock.plan_every`");
  }
}

std::vector<std::vector<Setting>> read_settings(const YamlValue& value) {
  std::vector<std::vector<Setting>> points = {{}};
  YamlMap map(value);
  for (const auto& path : map.keys()) {
    const YamlValue given = map.require(path);
    refuse_path(given, path);
    std::vector<std::vector<Setting>> longer;
    for (const auto& point : points) {
      for (const auto& item : given.is_list() ? distinct_items(given) : std::vector<YamlValue>{given}) {
        longer.push_back(point);
        longer.back().push_back({path, item});
      }
    }
    points = std::move(longer);
  }
  return points;
}

Variant read_variant(const YamlValue& value) {
  YamlMap map(value);
  Variant variant;
  variant.controller = controller_names()[map.require("controller").one_of(controller_names())];
  const auto name = map.find("name");
  variant.name = name ? plain_name(*name) : variant.controller;
  const auto settings = map.find("settings");
  variant.points = settings ? read_settings(*settings) : std::vector<std::vector<Setting>>{{}};
  map.finish();
  return variant;
}

std::vector<Variant> read_variants(const YamlValue& list) {
  std::vector<Variant> variants;
  std::set<std::string> names;
  for (const auto& item : distinct_items(list)) {
    variants.push_back(read_variant(item));
    if (!names.insert(variants.back().name).second) {
      throw item.error("variant `" + variants.back().name + "` is given twice; give this one another `name`");
    }
  }
  return variants;
}

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

std::vector<NamedFaults> read_faults(const std::optional<YamlValue>& value) {
  if (!value) {
    return {{"", std::nullopt}};
  }
  std::vector<NamedFaults> faults;
  YamlMap map(*value);
  for (const auto& name : map.keys()) {
    faults.push_back({name, read_schedule_of(map.require(name))});
  }
  if (faults.empty()) {
    throw value->error("names no schedule; leave `faults` out to have the scenario's own");
  }
  return faults;
}

/// A schedule's seed for one (day, seed) of the sweep.
YamlValue redrawn(const YamlValue& schedule, const std::string& day, std::uint64_t seed) {
  const auto own = YamlMap(schedule).find("seed");
  const std::string text = std::to_string(own ? own->seed() : 0) + " " + day + " " + std::to_string(seed);
  Digest digest;
  digest.update(text.data(), text.size());
  return YamlValue::parse(std::to_string(std::stoull(digest.hex().substr(0, 16), nullptr, 16)), schedule.file());
}

YamlValue with_faults(const YamlValue& scenario, const NamedFaults& faults, const std::string& day,
                      std::uint64_t seed) {
  const auto schedule = faults.schedule ? faults.schedule : YamlMap(scenario).find("faults");
  if (!schedule) {
    return scenario;
  }
  return scenario.with("faults", *schedule).with("faults.seed", redrawn(*schedule, day, seed));
}

/// The days as they are for every variant.
std::vector<SweptDay> occasions_of(const YamlValue& scenario, const std::vector<NamedFaults>& all_faults,
                                   const std::vector<YamlValue>& days, const std::vector<YamlValue>& seeds) {
  std::vector<SweptDay> occasions;
  for (const auto& faults : all_faults) {
    for (const auto& day : days) {
      for (const auto& seed : seeds) {
        SweptDay occasion{
            .faults = faults.name, .day = day.text(), .seed = seed.seed(), .yaml = scenario.with("day", day)};
        occasion.yaml = with_faults(occasion.yaml.with("seed", seed), faults, occasion.day, occasion.seed);
        occasions.push_back(std::move(occasion));
      }
    }
  }
  return occasions;
}

SweptDay at_point(SweptDay day, const Variant& variant, const std::vector<Setting>& point) {
  day.variant = variant.name;
  day.controller = variant.controller;
  for (const auto& setting : point) {
    day.settings[setting.path] = shown(setting.value);
    day.yaml = day.yaml.with(setting.path, setting.value);
  }
  return day;
}

std::vector<std::string> paths_of(const std::vector<Variant>& variants) {
  std::vector<std::string> paths;
  for (const auto& variant : variants) {
    for (const auto& setting : variant.points.front()) {
      if (std::find(paths.begin(), paths.end(), setting.path) == paths.end()) {
        paths.push_back(setting.path);
      }
    }
  }
  return paths;
}

}  // namespace

Sweep read_sweep(const fs::path& file) {
  YamlMap map(YamlValue::load(file));
  map.require("schema").integer(1, 1);
  const YamlValue base = map.require("scenario");
  const YamlValue scenario = YamlValue::load(file.parent_path() / base.text());
  const std::vector<Variant> variants = read_variants(map.require("variants"));
  const std::vector<NamedFaults> all_faults = read_faults(map.find("faults"));
  const std::vector<YamlValue> days = distinct_items(map.require("days"));
  const std::vector<YamlValue> seeds = distinct_items(map.require("seeds"));
  map.finish();

  Sweep sweep;
  sweep.settings = paths_of(variants);
  const std::vector<SweptDay> occasions = occasions_of(scenario, all_faults, days, seeds);
  for (const auto& variant : variants) {
    for (const auto& point : variant.points) {
      for (const auto& occasion : occasions) {
        sweep.days.push_back(at_point(occasion, variant, point));
      }
    }
  }
  return sweep;
}

Scenario scenario_of(const SweptDay& day) {
  Scenario scenario = read_scenario(day.yaml, {.controller = day.controller, .transport = "inproc"});
  scenario.regions_per_process = 1;
  scenario.expect.clear();
  return scenario;
}

}  // namespace evbal

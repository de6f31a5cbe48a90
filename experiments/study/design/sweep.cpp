#include "experiments/study/design/sweep.hpp"

#include "experiments/study/design/study_file.hpp"
#include "experiments/study/design/tuned.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

namespace evbal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t quick_days = 2;

/// A path with the values that it is to take in turn.
struct Axis {
  std::string path;
  std::vector<YamlValue> values;
};

struct Variant {
  YamlValue place;
  std::string name{};
  ChosenController controller{};       ///< without a name: that which was tuned
  std::string tuned{};                 ///< name in what was tuned; empty if it is not
  std::vector<Axis> settings{};        ///< in place of what was tuned, or beside it
  std::vector<Axis> factors{};         ///< of what was tuned
  std::vector<std::uint64_t> seeds{};  ///< none: the sweep's
};

using Point = std::vector<Setting>;

/// Axes in the order of the file, a value that is no list as a list of one.
std::vector<Axis> read_axes(const std::optional<YamlValue>& value) {
  std::vector<Axis> axes;
  if (value) {
    YamlMap map(*value);
    for (const auto& path : map.keys()) {
      const YamlValue given = map.require(path);
      refuse_path(given, path);
      axes.push_back({path, given.is_list() ? distinct_items(given) : std::vector<YamlValue>{given}});
    }
  }
  return axes;
}

/// Of more than two values the first and the last.
void keep_ends(std::vector<Axis>& axes) {
  for (Axis& axis : axes) {
    if (axis.values.size() > 2) {
      axis.values = {axis.values.front(), axis.values.back()};
    }
  }
}

Variant read_variant(const YamlValue& value) {
  YamlMap map(value);
  Variant variant{.place = value};
  const auto tuned = map.find("tuned");
  variant.tuned = tuned ? plain_name(*tuned) : "";
  if (!tuned || map.find("controller")) {
    variant.controller = read_chosen(map);
  }
  const auto name = map.find("name");
  variant.name = name ? plain_name(*name) : tuned ? variant.tuned : variant.controller.name;
  variant.settings = read_axes(map.find("settings"));
  const auto factors = map.find("factors");
  if (factors && !tuned) {
    throw factors->error("`factors` are of what was tuned; give `tuned` too");
  }
  variant.factors = read_axes(factors);
  if (const auto seeds = map.find("seeds")) {
    variant.seeds = read_seeds(*seeds);
  }
  map.finish();
  return variant;
}

std::vector<std::string> names_of(const std::vector<Variant>& variants) {
  std::vector<std::string> names;
  names.reserve(variants.size());
  for (const auto& variant : variants) {
    names.push_back(variant.name);
  }
  return names;
}

/// Each point with each value of the axis.
std::vector<Point> crossed(const std::vector<Point>& points, const Axis& axis) {
  std::vector<Point> longer;
  for (const auto& point : points) {
    for (const auto& value : axis.values) {
      longer.push_back(point);
      put(longer.back(), {axis.path, value});
    }
  }
  return longer;
}

/// The values that an axis of factors makes of what was tuned.
Axis scaled(Axis factors, const Point& tuned) {
  const auto base = std::find_if(tuned.begin(), tuned.end(), [&](const auto& s) { return s.path == factors.path; });
  for (auto& value : factors.values) {
    if (base == tuned.end()) {
      throw value.error("`" + factors.path + "` was not tuned, so it has no factors");
    }
    value = rounded_setting(base->value.number() * value.number(), value.file());
  }
  return factors;
}

/// What was tuned for a scenario.
std::vector<std::string> tuned_for_scenario(const Tuned& all_tuned, const std::string& scenario) {
  std::vector<std::string> names;
  for (const auto& [of, settings] : all_tuned) {
    if (of.first == scenario) {
      names.push_back(of.second);
    }
  }
  return names;
}

/// What a variant is in one scenario.
struct InScenario {
  ChosenController controller;
  std::vector<Point> points;  ///< every combination of its settings
};

InScenario in_scenario(const Variant& variant, const std::string& scenario, const Tuned& all_tuned) {
  InScenario result{variant.controller, {{}}};
  if (!variant.tuned.empty()) {
    const auto found = all_tuned.find({scenario, variant.tuned});
    if (found == all_tuned.end()) {
      throw variant.place.error("nothing called `" + variant.tuned + "` was tuned for scenario `" + scenario + "`" +
                                did_you_mean(variant.tuned, tuned_for_scenario(all_tuned, scenario)));
    }
    result.points = {found->second.settings};
    if (result.controller.name.empty()) {
      result.controller = found->second.controller;
    }
  }
  const Point tuned = result.points.front();
  for (const auto& axis : variant.settings) {
    result.points = crossed(result.points, axis);
  }
  for (const auto& axis : variant.factors) {
    result.points = crossed(result.points, scaled(axis, tuned));
  }
  return result;
}

/// What was tuned, by the sweep's `tuning` or by a file that it names.
Tuned tuned_for(YamlMap& map, const SweepReading& reading) {
  const auto file = map.find("tuned");
  const auto tuning = map.find("tuning");
  if (file && tuning) {
    throw file->error("`tuned` and `tuning` are both given; keep one");
  }
  if (file) {
    return read_tuned(fs::path(file->file()).parent_path() / file->text());
  }
  return reading.tuned.empty() ? Tuned{} : read_tuned(reading.tuned);
}

}  // namespace

Sweep read_sweep(const fs::path& file, const SweepReading& reading) {
  YamlMap map(YamlValue::load(file));
  map.require("schema").integer(1, 1);
  std::vector<Variant> variants = read_variants(map.require("variants"), read_variant);
  Replications replications(map);
  const Tuned tuned = tuned_for(map, reading);
  const auto bound = map.find("bound");
  const auto page = map.find("page");
  map.finish();
  if (reading.quick) {
    replications.cut(quick_days, 1);
    for (Variant& variant : variants) {
      keep_ends(variant.settings);
      keep_ends(variant.factors);
      variant.seeds.resize(std::min<std::size_t>(variant.seeds.size(), 1));
    }
  }

  Sweep sweep;
  sweep.bound = bound ? read_bound_wish(*bound) : BoundWish{};
  sweep.page =
      page ? std::optional(read_page(*page, {names_of(variants), replications.scenarios(), replications.faults()}))
           : std::nullopt;
  for (const auto& variant : variants) {
    for (const auto& name : replications.scenarios()) {
      const auto& other = replications.tuned_as(name);
      const InScenario here = in_scenario(variant, other ? other->text() : name, tuned);
      const auto days = replications.of(name, variant.seeds);
      for (const auto& point : here.points) {
        note_paths(point, sweep.settings);
        for (const auto& replication : days) {
          sweep.days.push_back(day_of(replication, variant.name, here.controller, point));
        }
      }
    }
  }
  return sweep;
}

std::vector<std::size_t> days_to_bound(const Sweep& sweep, const BoundWish& wish) {
  std::vector<std::size_t> positions;
  std::set<std::tuple<std::string, std::string, std::uint64_t>> bounded;
  std::set<std::tuple<std::string, std::string, std::uint64_t, std::string>> looked_at;
  for (std::size_t i = 0; i < sweep.days.size(); ++i) {
    const SweptDay& day = sweep.days[i];
    const bool wanted = std::find(wish.seeds.begin(), wish.seeds.end(), day.seed) != wish.seeds.end() &&
                        !bounded.contains({day.scenario, day.day, day.seed}) &&
                        looked_at.emplace(day.scenario, day.day, day.seed, day.faults).second;
    if (wanted && scenario_of(day).schedule.faults.empty()) {
      bounded.emplace(day.scenario, day.day, day.seed);
      positions.push_back(i);
    }
  }
  return positions;
}

fs::path tuning_of(const fs::path& file) {
  YamlMap map(YamlValue::load(file));
  const auto tuning = map.find("tuning");
  return tuning ? file.parent_path() / tuning->text() : fs::path();
}

SweptDay day_of(const PlannedReplication& replication, const std::string& variant, const ChosenController& controller,
                const std::vector<Setting>& settings) {
  SweptDay day{.scenario = replication.scenario,
               .variant = variant,
               .controller = controller.name,
               .coordinator = controller.coordinator,
               .faults = replication.faults,
               .day = replication.day,
               .seed = replication.seed,
               .yaml = replication.yaml};
  for (const auto& setting : settings) {
    day.settings[setting.path] = shown(setting.value);
    day.yaml = day.yaml.with(setting.path, setting.value);
  }
  return day;
}

std::string label_of(const SweptDay& day) {
  std::string text = (day.scenario.empty() ? "" : day.scenario + " ") + day.variant;
  for (const auto& [path, value] : day.settings) {
    text.append(" ").append(path).append("=").append(value);
  }
  return text + (day.faults.empty() ? "" : " " + day.faults) + " " + day.day + " seed " + std::to_string(day.seed);
}

Scenario scenario_of(const SweptDay& day) {
  Scenario scenario =
      read_scenario(day.yaml, {.controller = day.controller, .coordinator = day.coordinator, .transport = "inproc"});
  if (scenario.draws.size() > 1) {
    throw day.yaml.error(
        "a sweep draws one schedule of faults for each day and seed; leave its `runs` out and give more "
        "`seeds`");
  }
  scenario.regions_per_process = 1;
  scenario.expect.clear();
  scenario.cross_check = CrossCheck::off;
  scenario.security.reset();
  return scenario;
}

}  // namespace evbal

#include "experiments/study/design/tuned.hpp"

#include "common/decimal.hpp"
#include "common/yaml_writer.hpp"
#include "experiments/study/design/study_file.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

constexpr auto one_line = YamlWriter::Layout::one_line;

TunedGain read_gain(const YamlValue& value) {
  YamlMap map(value);
  TunedGain gain{.replications = map.require("replications").integer(0, std::numeric_limits<int>::max()),
                 .mean = map.require("mean").number()};
  if (const auto low = map.find("low")) {
    gain.low = low->number();
    gain.high = map.require("high").number();
  }
  map.finish();
  return gain;
}

TuningOutcome read_outcome(const YamlValue& value) {
  YamlMap map(value);
  TuningOutcome outcome{.tried = map.require("tried").integer(),
                        .days = map.require("days").integer(),
                        .objective = map.require("objective").number(),
                        .over_second = read_gain(map.require("over_second")),
                        .over_first_round = read_gain(map.require("over_first_round"))};
  for (const auto& edge : map.require("edges").items()) {
    outcome.edges.push_back(edge.text());
  }
  map.finish();
  return outcome;
}

void write_gain(YamlWriter& yaml, const TunedGain& gain) {
  yaml.begin_map(one_line).key("replications").number(gain.replications).key("mean").word(fixed(gain.mean, 2));
  if (std::isfinite(gain.low) && std::isfinite(gain.high)) {
    yaml.key("low").word(fixed(gain.low, 2)).key("high").word(fixed(gain.high, 2));
  }
  yaml.end_map();
}

void write_outcome(YamlWriter& yaml, const TuningOutcome& outcome) {
  yaml.begin_map(one_line).key("tried").number(outcome.tried).key("days").number(outcome.days);
  yaml.key("objective").word(fixed(outcome.objective, 2)).key("over_second");
  write_gain(yaml, outcome.over_second);
  yaml.key("over_first_round");
  write_gain(yaml, outcome.over_first_round);
  yaml.key("edges").begin_list(one_line);
  for (const auto& edge : outcome.edges) {
    yaml.text(edge);
  }
  yaml.end_list().end_map();
}

}  // namespace

double TuningOutcome::regret() const {
  return over_second.replications == 0 ? 0.0 : std::max(0.0, -over_second.low);
}

Tuned read_tuned(const std::filesystem::path& file) {
  Tuned tuned;
  YamlMap map(YamlValue::load(file));
  map.require("schema").integer(1, 1);
  YamlMap scenarios(map.require("tuned"));
  map.finish();
  for (const auto& scenario : scenarios.keys()) {
    YamlMap variants(scenarios.require(scenario));
    for (const auto& name : variants.keys()) {
      YamlMap variant(variants.require(name));
      TunedVariant& entry = tuned[{scenario, name}];
      entry.controller = read_chosen(variant);
      YamlMap settings(variant.require("settings"));
      if (const auto outcome = variant.find("search")) {
        entry.outcome = read_outcome(*outcome);
      }
      variant.finish();
      for (const auto& path : settings.keys()) {
        entry.settings.push_back({path, settings.require(path)});
        refuse_path(entry.settings.back().value, path);
      }
    }
  }
  return tuned;
}

std::string tuned_yaml(const Tuned& tuned) {
  YamlWriter yaml;
  yaml.key("schema").number(1).key("tuned").begin_map();
  for (auto variant = tuned.begin(); variant != tuned.end();) {
    const std::string& scenario = variant->first.first;
    yaml.key(scenario).begin_map();
    for (; variant != tuned.end() && variant->first.first == scenario; ++variant) {
      yaml.key(variant->first.second).begin_map(one_line).key("controller").word(variant->second.controller.name);
      write_coordinator(yaml, variant->second.controller.coordinator);
      yaml.key("settings").begin_map();
      for (const auto& [path, value] : variant->second.settings) {
        yaml.key(path).value(value);
      }
      yaml.end_map();
      if (variant->second.outcome) {
        yaml.key("search");
        write_outcome(yaml, *variant->second.outcome);
      }
      yaml.end_map();
    }
    yaml.end_map();
  }
  return yaml.end_map().finish();
}

}  // namespace evbal

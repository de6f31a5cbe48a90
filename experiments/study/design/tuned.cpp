#include "experiments/study/design/tuned.hpp"

#include "common/yaml_writer.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "experiments/metrics/metrics.hpp"
#include "experiments/study/design/replications.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace evbal {

void put(std::vector<Setting>& settings, const Setting& setting) {
  const auto there =
      std::find_if(settings.begin(), settings.end(), [&](const Setting& old) { return old.path == setting.path; });
  if (there == settings.end()) {
    settings.push_back(setting);
  } else {
    *there = setting;
  }
}

void note_paths(const std::vector<Setting>& settings, std::vector<std::string>& paths) {
  for (const auto& setting : settings) {
    if (std::find(paths.begin(), paths.end(), setting.path) == paths.end()) {
      paths.push_back(setting.path);
    }
  }
}

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

YamlValue rounded_setting(double value, const std::string& file) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return YamlValue::parse(text.data(), file);
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
      entry.controller = controller_names()[variant.require("controller").one_of(controller_names())];
      YamlMap settings(variant.require("settings"));
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
  constexpr auto one_line = YamlWriter::Layout::one_line;
  YamlWriter yaml;
  yaml.key("schema").number(1).key("tuned").begin_map();
  for (auto variant = tuned.begin(); variant != tuned.end();) {
    const std::string& scenario = variant->first.first;
    yaml.key(scenario).begin_map();
    for (; variant != tuned.end() && variant->first.first == scenario; ++variant) {
      yaml.key(variant->first.second).begin_map(one_line).key("controller").word(variant->second.controller);
      yaml.key("settings").begin_map();
      for (const auto& [path, value] : variant->second.settings) {
        yaml.key(path).value(value);
      }
      yaml.end_map().end_map();
    }
    yaml.end_map();
  }
  return yaml.end_map().finish();
}

}  // namespace evbal

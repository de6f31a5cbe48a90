#include "experiments/study/design/variant_settings.hpp"

#include "coordinator/planning/settings.hpp"
#include "experiments/metrics/metrics.hpp"
#include "experiments/study/design/study_file.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace evbal {

ChosenController read_chosen(YamlMap& variant) {
  ChosenController chosen;
  if (const auto coordinator = variant.find("coordinator")) {
    chosen.coordinator = read_command(*coordinator);
  }
  chosen.name = read_controller(variant.require("controller"), chosen.coordinator);
  return chosen;
}

void write_coordinator(YamlWriter& yaml, const Command& coordinator) {
  if (!coordinator.empty()) {
    yaml.key("coordinator").begin_list(YamlWriter::Layout::one_line);
    for (const auto& word : coordinator) {
      yaml.text(word);
    }
    yaml.end_list();
  }
}

void put(std::vector<Setting>& settings, const Setting& setting) {
  const auto there =
      std::find_if(settings.begin(), settings.end(), [&](const Setting& old) { return old.path == setting.path; });
  if (there == settings.end()) {
    settings.push_back(setting);
  } else {
    *there = setting;
  }
}

std::string shown_settings(const std::vector<Setting>& settings) {
  std::string text;
  for (const auto& [path, value] : settings) {
    text += (text.empty() ? "" : " ") + path + "=" + shown(value);
  }
  return text;
}

void note_paths(const std::vector<Setting>& settings, std::vector<std::string>& paths) {
  for (const auto& setting : settings) {
    if (std::find(paths.begin(), paths.end(), setting.path) == paths.end()) {
      paths.push_back(setting.path);
    }
  }
}

void refuse_path(const YamlValue& value, const std::string& path) {
  static constexpr std::array own = {
      "schema", "name",      "day",    "seed",        "controller",          "controllers", "coordinator",
      "faults", "transport", "expect", "cross_check", "regions_per_process", "security",    "hosts"};
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

}  // namespace evbal

#include "tools/evbal/sourced_scenario.hpp"

#include "common/installation.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

namespace evbal {
namespace {

/// A scalar as YAML, in quotes if it could be taken for something else.
std::string quoted(const std::string& text) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-+/";
  const bool is_plain = !text.empty() && text != "null" && text != "Null" && text != "NULL" && text.front() != '-' &&
                        text.find_first_not_of(plain) == std::string::npos;
  if (is_plain) {
    return text;
  }
  std::string escaped;
  for (const char letter : text) {
    escaped += letter == '"' || letter == '\\' ? std::string{'\\', letter} : std::string{letter};
  }
  return '"' + escaped + '"';
}

/// Any value as YAML in one line.
std::string one_line(const YamlValue& value) {
  if (value.is_scalar()) {
    return quoted(value.text());
  }
  std::string text;
  if (value.is_list()) {
    for (const auto& item : value.items()) {
      text += (text.empty() ? "" : ", ") + one_line(item);
    }
    return "[" + text + "]";
  }
  YamlMap map(value);
  for (const auto& key : map.keys()) {
    text += (text.empty() ? "" : ", ") + key + ": " + one_line(map.require(key));
  }
  return "{" + text + "}";
}

bool holds_maps(const YamlValue& value) {
  return value.is_list() && !value.items().empty() && value.items().front().is_map();
}

/// The option that stands in place of a key of the scenario, if it was given.
std::optional<std::string> option_for(const std::string& path, const Overrides& overrides) {
  const std::string key = path.substr(0, path.find('.'));
  const std::array<std::tuple<const char*, bool, const char*>, 8> options = {{
      {"controller", overrides.controller.has_value(), "--controller"},
      {"coordinator", overrides.coordinator.has_value(), "--coordinator"},
      {"day", overrides.day.has_value(), "--day"},
      {"seed", overrides.seed.has_value(), "--seed"},
      {"transport", overrides.transport.has_value(), "--transport"},
      {"regions_per_process", overrides.regions_per_process.has_value(), "--regions-per-process"},
      {"engine", overrides.engine.has_value(), "--engine"},
      {"dds_profiles", overrides.dds_profiles.has_value(), "--dds-profiles"},
  }};
  for (const auto& [name, given, option] : options) {
    if (given && key == name) {
      return option;
    }
  }
  return std::nullopt;
}

/// What stands where nothing is given.
std::string source_of_default(const std::string& path) {
  if (path == "name") {
    return "the file's name";
  }
  const bool of_pack = path == "clock.start" || path == "stations" || path.starts_with("fleet.") ||
                       path == "charging.power_kw" || path == "charging.session_quantiles" ||
                       path.starts_with("passengers.");
  return of_pack ? "the city's pack" : "default";
}

/// Writes the lines of a resolved scenario.
class Lines {
 public:
  Lines(const Overrides& overrides, std::size_t draws, SourcedScenario& out)
      : overrides_(overrides), draws_(draws), out_(out) {}

  /// Those of a map at `path`, of which `given` is what the user wrote.
  void add(const YamlValue& resolved, const std::optional<YamlValue>& given, const std::string& path) {
    YamlMap map(resolved);
    const std::string prefix = path.empty() ? "" : path + ".";
    for (const auto& key : map.keys()) {
      add_value(key, map.require(key), find(given, key), prefix + key);
    }
  }

  /// All of them, the sources below each other.
  std::string text() const {
    constexpr std::size_t widest = 40;
    std::size_t width = 0;
    for (const auto& [line, source] : lines_) {
      width = std::max(width, source.empty() ? 0 : std::min(widest, line.size()));
    }
    std::string text;
    for (const auto& [line, source] : lines_) {
      const std::string space(line.size() < width ? width - line.size() : 0, ' ');
      text += line;
      if (!source.empty()) {
        text.append(space).append("  # ").append(source);
      }
      text += "\n";
    }
    return text;
  }

 private:
  /// One controller may be given as a list of one.
  static std::optional<YamlValue> find(const std::optional<YamlValue>& given, const std::string& key) {
    if (!given || !given->is_map()) {
      return std::nullopt;
    }
    YamlMap map(*given);
    const auto found = map.find(key);
    return !found && key == "controller" ? map.find("controllers") : found;
  }

  std::string source_of(const std::string& path, const std::optional<YamlValue>& given) const {
    if (const auto option = option_for(path, overrides_)) {
      return *option;
    }
    if (!given) {
      return path == "faults.resolved" ? "drawn" : source_of_default(path);
    }
    const std::string file = std::filesystem::path(given->file()).filename().string();
    std::string place = given->line() == 0 ? "--set" : file + ":" + std::to_string(given->line());
    if (path != "faults.faults") {
      return place;
    }
    return (draws_ > 1 ? "the first of " + std::to_string(draws_) + " draws from " : "drawn from ") + place;
  }

  void add_value(const std::string& key, const YamlValue& value, const std::optional<YamlValue>& given,
                 const std::string& path) {
    const std::string indent(2 * static_cast<std::size_t>(std::count(path.begin(), path.end(), '.')), ' ');
    if (value.is_map()) {
      lines_.emplace_back(indent + key + ":", "");
      add(value, given, path);
      return;
    }
    out_.sources.emplace_back(path, source_of(path, given));
    const bool below = holds_maps(value);
    lines_.emplace_back(indent + key + ":" + (below ? "" : " " + one_line(value)), out_.sources.back().second);
    if (below) {
      for (const auto& item : value.items()) {
        lines_.emplace_back(indent + "  - " + one_line(item), "");
      }
    }
  }

  const Overrides& overrides_;
  std::size_t draws_;
  SourcedScenario& out_;
  std::vector<std::pair<std::string, std::string>> lines_;  ///< with what they hold, and its source
};

/// The scenario's text, with all of its controllers.
std::string resolved_text(const Scenario& scenario) {
  std::string text = resolved_yaml(scenario, scenario.controllers.front());
  if (scenario.controllers.size() > 1) {
    std::string all;
    for (const auto& controller : scenario.controllers) {
      all += (all.empty() ? "" : ", ") + controller;
    }
    const std::string one = "\ncontroller: " + scenario.controllers.front() + "\n";
    text.replace(text.find(one), one.size(), "\ncontrollers: [" + all + "]\n");
  }
  return text;
}

}  // namespace

SourcedScenario sourced_scenario(const std::filesystem::path& file, const Overrides& overrides) {
  const YamlValue written = YamlValue::load(file);
  const Scenario scenario = read_scenario(written, overrides);
  YamlValue given = with_settings(written, overrides.settings);
  if (overrides.faults) {
    given = given.with("faults", YamlValue::load(find_shipped("faults", *overrides.faults)));
  }
  SourcedScenario out{YamlValue::parse(resolved_text(scenario), file.string()), "", {}};
  Lines lines(overrides, scenario.draws.size(), out);
  lines.add(out.resolved, given, "");
  out.text = lines.text();
  return out;
}

}  // namespace evbal

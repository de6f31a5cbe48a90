#pragma once

#include "common/command.hpp"
#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

#include <string>
#include <vector>

/// What a variant changes in a scenario (docs/sweeps.md).
namespace evbal {

/// A path of a scenario, such as `balancing.tau`, with the value that it is to take.
struct Setting {
  std::string path;  ///< keys with dots between them
  YamlValue value;   ///< of the last key
};

/// Who plans in a variant.
struct ChosenController {
  std::string name{};     ///< of the controller
  Command coordinator{};  ///< that knows it; empty: evbal's
};

/// Reads the keys `controller`, which must be there, and `coordinator` of a variant. Throws Error{bad_input}.
ChosenController read_chosen(YamlMap& variant);

/// Writes the key `coordinator` of a variant that has one.
void write_coordinator(YamlWriter& yaml, const Command& coordinator);

/// Sets `path`, in place of a setting of it that is there.
void put(std::vector<Setting>& settings, const Setting& setting);

/// `PATH=VALUE`, with spaces between settings.
std::string shown_settings(const std::vector<Setting>& settings);

/// Appends the paths of `settings` that are not there yet.
void note_paths(const std::vector<Setting>& settings, std::vector<std::string>& paths);

/// Throws Error{bad_input} if `path` is something that a sweep says elsewhere, what has no influence on a day, or the
/// name of a metric, which would be a column twice.
void refuse_path(const YamlValue& value, const std::string& path);

/// `value` as a setting: rounded to four digits, which is what is written and what is played.
YamlValue rounded_setting(double value, const std::string& file);

}  // namespace evbal

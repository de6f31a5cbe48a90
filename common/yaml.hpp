#pragma once

#include "common/error.hpp"
#include "common/suggestion.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace YAML {
class Node;
}

namespace evbal {

/// A node of a YAML file that knows its place. Stricter than YAML: numbers are plain decimal, booleans are
/// `true` and `false`, durations and times carry their unit, keys are not repeated. Everything that does not fit
/// throws Error{bad_input} as "file:line: what, and what would be right".
class YamlValue {
 public:
  /// Reads a whole file. Throws if it is missing, empty, no YAML, not in UTF-8 or of several documents.
  static YamlValue load(const std::filesystem::path& file);

  /// Reads `text`; `name` stands for the file in messages.
  static YamlValue parse(const std::string& text, const std::string& name);

  /// Reads what the command line gives `option`, which stands for the file in messages and has no lines. Paths in it
  /// are taken from the current directory.
  static YamlValue parse_option(const std::string& text, const std::string& option);

  /// Whether it is a map.
  bool is_map() const;
  /// Whether it is a list.
  bool is_list() const;
  /// Whether it is a scalar.
  bool is_scalar() const;

  /// A text of one line, without control characters.
  std::string text() const;

  /// A text of any number of lines.
  std::string paragraphs() const;

  /// A text after which files may be named (validate_file_name in common/plain_text.hpp).
  std::string file_name() const;

  /// A finite number.
  double number() const;
  double number(double low, double high) const;  ///< within [low, high]
  /// A whole number.
  int integer() const;
  int integer(int low, int high) const;  ///< within [low, high]
  std::uint64_t seed() const;            ///< whole number in 0..2^64-1
  /// True or false.
  bool boolean() const;

  /// "90min", "1.5h", "30s", "20ms" as minutes, not negative; "4.1h" is 246.
  double duration() const;

  /// The same from `low` to `high` minutes.
  double duration(double low, double high) const;

  /// A duration of whole minutes, at least 1.
  int whole_minutes() const;

  /// "17:30" as minutes after midnight, up to "24:00".
  int time_of_day() const;

  /// One of `words`, as its position.
  std::size_t one_of(const std::vector<std::string>& words) const;

  std::vector<YamlValue> items() const;  ///< of a list

  /// The node as YAML text of its own, settings of with() left out.
  std::string dump() const;

  /// The same map, in which `path`, keys joined by dots such as `balancing.tau`, is `value`, given there before or not.
  /// What is wrong with `value` is then reported at its own place.
  YamlValue with(const std::string& path, const YamlValue& value) const;

  /// An Error{bad_input} at its line.
  Error error(const std::string& message) const;
  /// In the file, from 1; 0 if it was read from no file.
  int line() const;
  /// That it was read from, or the option.
  const std::string& file() const;

 private:
  friend class YamlMap;
  friend class YamlWriter;

  struct Source;
  YamlValue(std::shared_ptr<const YAML::Node> node, std::shared_ptr<const Source> source);
  static YamlValue parse(const std::string& text, Source source);

  const std::string& scalar(const char* expected) const;

  struct Setting;

  std::shared_ptr<const YAML::Node> node_;
  std::shared_ptr<const Source> source_;
  std::vector<Setting> settings_;  ///< that stand in place of the node's own, or beside them
};

/// A key of a map, and its value.
struct YamlValue::Setting {
  std::string path;  ///< below the value
  YamlValue value;   ///< of the key
};

/// A YAML map whose keys are asked for by name. finish() refuses the keys that nobody asked for.
class YamlMap {
 public:
  /// Throws if `value` is no map or repeats a key.
  explicit YamlMap(const YamlValue& value);

  /// The value of a key, if the map has it.
  std::optional<YamlValue> find(const std::string& key);

  /// Throws if the key is missing.
  YamlValue require(const std::string& key);

  /// Keys in the order of the file.
  const std::vector<std::string>& keys() const { return order_; }

  /// Throws on the first key that was never asked for, naming those that were.
  void finish() const;

  /// The map itself.
  const YamlValue& value() const { return value_; }

 private:
  void set(const YamlValue::Setting& setting);

  YamlValue value_;
  std::vector<std::string> order_;
  std::map<std::string, YamlValue> entries_;
  std::map<std::string, YamlValue> key_places_;
  std::set<std::string> known_;
};

}  // namespace evbal

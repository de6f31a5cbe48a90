#pragma once

#include "common/decimal.hpp"

#include <memory>
#include <string>

namespace evbal {

class YamlValue;

/// Writes a YAML map key by key, so that YamlValue reads back the same: yaml.key("name").text(name). Keys and values
/// alternate in a map; in a list values follow each other.
class YamlWriter {
 public:
  /// Whether each entry has a line of its own, or all stand on one: `{a: 1, b: 2}`.
  enum class Layout { lines, one_line };

  YamlWriter();
  ~YamlWriter();
  YamlWriter(const YamlWriter&) = delete;
  YamlWriter& operator=(const YamlWriter&) = delete;

  /// A key; its value comes next.
  YamlWriter& key(const std::string& name);

  /// A value in double quotes, whatever it holds.
  YamlWriter& text(const std::string& value);

  /// A value that needs no quotes, such as a word of the schema.
  YamlWriter& word(const std::string& value);

  /// A value as it was read, settings of with() left out.
  YamlWriter& value(const YamlValue& value);

  /// A number, in the shortest decimals that give it back.
  template <class Number>
  YamlWriter& number(Number value) {
    return word(decimal(value));
  }
  /// A duration, such as `90min`.
  YamlWriter& minutes(double value) { return word(decimal(value) + "min"); }
  /// `true` or `false`.
  YamlWriter& boolean(bool value) { return word(value ? "true" : "false"); }

  /// A map as the value that comes next.
  YamlWriter& begin_map(Layout layout = Layout::lines);
  /// Ends the map that was begun last.
  YamlWriter& end_map();
  /// A list as the value that comes next.
  YamlWriter& begin_list(Layout layout = Layout::lines);
  /// Ends the list that was begun last.
  YamlWriter& end_list();

  /// The text of the whole map; nothing may be written after that.
  std::string finish();

 private:
  struct Emitter;
  std::unique_ptr<Emitter> emitter_;
};

}  // namespace evbal

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
  enum class Layout { lines, one_line };

  YamlWriter();
  ~YamlWriter();
  YamlWriter(const YamlWriter&) = delete;
  YamlWriter& operator=(const YamlWriter&) = delete;

  YamlWriter& key(const std::string& name);

  /// A value in double quotes, whatever it holds.
  YamlWriter& text(const std::string& value);

  /// A value that needs no quotes, such as a word of the schema.
  YamlWriter& word(const std::string& value);

  /// A value as it was read, settings of with() left out.
  YamlWriter& value(const YamlValue& value);

  template <class Number>
  YamlWriter& number(Number value) {
    return word(decimal(value));
  }
  YamlWriter& minutes(double value) { return word(decimal(value) + "min"); }
  YamlWriter& boolean(bool value) { return word(value ? "true" : "false"); }

  YamlWriter& begin_map(Layout layout = Layout::lines);
  YamlWriter& end_map();
  YamlWriter& begin_list(Layout layout = Layout::lines);
  YamlWriter& end_list();

  /// The text of the whole map; nothing may be written after that.
  std::string finish();

 private:
  struct Emitter;
  std::unique_ptr<Emitter> emitter_;
};

}  // namespace evbal

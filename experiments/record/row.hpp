#pragma once

#include "agents/protocol/reflection.hpp"
#include "agents/protocol/words.hpp"
#include "common/decimal.hpp"
#include "faults/schedule/fault_types.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace evbal {

/// One column of a row of run.sqlite.
struct Cell {
  std::string name;                                       ///< of the column
  std::variant<std::int64_t, double, std::string> value;  ///< in the column
};

/// The cells of a row, in the order of the columns.
using Row = std::vector<Cell>;

/// As schedules write it.
inline const std::string& word(EffectType type) {
  return fault_type(type).name;
}

/// Appends the columns of a message to a row (day_file.hpp says which).
class RowWriter {
 public:
  /// Adds cells to `row`, whose names begin with `prefix`.
  explicit RowWriter(Row& row, std::string prefix = "") : row_(row), prefix_(std::move(prefix)) {}

  /// Adds a field.
  template <class Field>
  void operator()(std::string_view name, const Field& field) {
    const std::string column = prefix_ + std::string(name);
    const bool reserved = column == "from" || column == "to";
    write(reserved ? column + "_region" : column, field);
  }

 private:
  template <class Number>
  requires std::is_integral_v<Number>
  void write(const std::string& name, Number value) { row_.push_back({name, std::int64_t{value}}); }

  void write(const std::string& name, double value) { row_.push_back({name, value}); }

  void write(const std::string& name, const std::string& value) { row_.push_back({name, value}); }

  template <class Word>
  requires std::is_enum_v<Word>
  void write(const std::string& name, Word value) { row_.push_back({name, std::string(word(value))}); }

  void write(const std::string& name, const std::vector<std::int32_t>& values) {
    std::string text;
    for (const auto value : values) {
      text.append(text.empty() ? "" : " ").append(decimal(value));
    }
    row_.push_back({name, text});
  }

  void write(const std::string& name, const std::vector<UnderWay>& cars) {
    std::string text;
    for (const auto& car : cars) {
      text.append(text.empty() ? "" : " ").append(decimal(car.minute)).append(":");
      text.append(word(car.errand)).append(":").append(decimal(car.count));
    }
    row_.push_back({name, text});
  }

  /// Lists of messages are tables of their own.
  template <class Message>
  requires std::is_class_v<Message>
  void write(const std::string& /*name*/, const std::vector<Message>& /*messages*/) {}

  template <class Message>
  requires std::is_class_v<Message>
  void write(const std::string& name, const Message& message) {
    RowWriter part(row_, name + "_");
    for_each_field(message, part);
  }

  Row& row_;
  std::string prefix_;
};

/// The key's columns, then the message's.
template <class Message>
Row row_of(Row key, const Message& message) {
  RowWriter writer(key);
  for_each_field(message, writer);
  return key;
}

}  // namespace evbal

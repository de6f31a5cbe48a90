#pragma once

#include "common/error.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// The whole of `text` as a number in plain decimal, or nothing.
std::optional<double> parse_number(std::string_view text);

/// The whole of `text` as a whole number, or nothing.
std::optional<long long> parse_integer(std::string_view text);

/// A strict reader of a pack's CSV tables: a fixed header, as many fields in every line, a newline at the end of every
/// line (so that a truncated file shows). Everything else throws Error{bad_input} with file and line.
class PackTable {
 public:
  /// Reads `file`, whose first line must be `header`.
  PackTable(const std::filesystem::path& file, const std::string& header);

  /// Moves to the next row; false at the end.
  bool next();

  /// A field of the row by its column.
  std::string_view text(std::size_t column) const;
  int integer(std::size_t column, int low, int high) const;          ///< within [low, high]
  double number(std::size_t column, double low, double high) const;  ///< within [low, high]

  /// An error at the current row.
  Error error(const std::string& message) const;

 private:
  std::optional<std::string_view> next_line();

  std::string file_;
  std::string content_;
  std::size_t at_ = 0;
  int line_ = 0;
  std::vector<std::string> names_;
  std::vector<std::string> fields_;
};

}  // namespace evbal

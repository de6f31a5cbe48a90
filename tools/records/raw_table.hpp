#pragma once

#include "common/yaml.hpp"
#include "tools/records/text_lines.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// How a table of raw records is laid out.
struct TableFormat {
  char separator = ',';  ///< a blank stands for any number of blanks and tabs
  bool header = true;    ///< the first line names the columns
  /// The columns that are asked for: by name with a header, else by number from 1.
  std::vector<std::string> columns;
};

/// Reads the keys `separator` (comma, semicolon, tab, space; comma unless given) and `header` (true unless given).
TableFormat read_table_format(YamlMap& map);

/// Appends the column that `value` names (by number if there is no header) and returns its position among those asked
/// for.
std::size_t add_column(TableFormat& format, const YamlValue& value);

/// The reason under which rows are counted that lack fields or whose fields cannot be read.
inline constexpr const char* malformed_row = "malformed row";

/// The rows of a table of raw records, plain or compressed, as a stream. Unlike PackTable it takes what other people's
/// programs write: any of several separators, blanks around fields, columns in any order, quotes or none.
class RawTable {
 public:
  /// Throws Error{bad_input} if the file cannot be read or its header lacks a column.
  RawTable(const std::filesystem::path& file, const TableFormat& format);

  /// Moves to the next row that is not empty; false at the end. Throws as LineReader does.
  bool next();

  /// False if the row has too few fields; then text() must not be called.
  bool whole() const { return whole_; }

  /// A field of the row by its position among the columns asked for, without blanks around it.
  std::string_view text(std::size_t column) const { return fields_[column]; }

  /// An error at the current row.
  Error error(const std::string& message) const { return lines_.error(message); }

  /// The file that is read.
  const std::string& file() const { return lines_.file(); }

  /// The number of the current row's line, from 1.
  int line() const { return lines_.line(); }

 private:
  void find_columns();
  void split();
  void split_quoted();

  LineReader lines_;
  TableFormat format_;
  std::vector<std::size_t> places_;  ///< in the line, by column asked for
  std::size_t most_ = 0;             ///< of places_
  std::string line_;
  std::vector<std::string_view> all_;
  std::vector<std::string> unquoted_;
  std::vector<std::string_view> fields_;
  bool whole_ = false;
};

}  // namespace evbal

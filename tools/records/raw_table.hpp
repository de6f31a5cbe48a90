#pragma once

#include "common/yaml.hpp"
#include "tools/records/csv_rows.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// How a table of raw records is laid out.
struct TableFormat {
  char separator = ',';        ///< a blank stands for any number of blanks and tabs
  bool header = true;          ///< the first row names the columns
  int skip_rows = 0;           ///< lines before the header, or before the first row if there is none
  bool decimal_comma = false;  ///< numbers are written 52,35
  /// The columns that are asked for: by name with a header, else by number from 1.
  std::vector<std::string> columns;
};

/// Reads the keys `separator` (comma, semicolon, tab, space; comma unless given), `header` (true unless given),
/// `skip_rows` (0 unless given) and `decimal` (point, comma; point unless given).
TableFormat read_table_format(YamlMap& map);

/// Appends the column that `value` names (by number if there is no header) and returns its position among those asked
/// for.
std::size_t add_column(TableFormat& format, const YamlValue& value);

/// Why a row does not count.
struct RowFault {
  std::string_view reason;  ///< under which it is counted; empty: it has no fault
  std::string_view value;   ///< what stands there instead
  bool unreadable = true;   ///< false if the row can be read but is of no use

  /// True if there is a fault.
  explicit operator bool() const { return !reason.empty(); }
};

/// A column asked for as messages call it: "`began`", or "column 3" if there is no header.
std::string column_name(const TableFormat& format, std::size_t column);

/// The rows of a table of raw records, plain or compressed, as a stream. Unlike PackTable it takes what other people's
/// programs write: any of several separators, blanks around fields, columns in any order, quotes or none.
class RawTable {
 public:
  /// Throws Error{bad_input} if the file cannot be read or its header lacks a column, or has it twice.
  RawTable(const std::filesystem::path& file, const TableFormat& format);

  /// Moves to the next row that is not empty; false at the end. Throws as LineReader does.
  bool next();

  /// False if the row is at fault as a whole; then fields must not be asked for.
  bool whole() const { return !fault_; }

  /// What is wrong with the row as a whole: too few fields, more than the header names, a quote without its other
  /// half, a NUL byte.
  const RowFault& fault() const { return fault_; }

  /// A field of the row by its position among the columns asked for, without blanks around it.
  std::string_view text(std::size_t column) const { return fields_[column]; }

  /// The field as a number, with a comma if the format says so; nothing if it is none.
  std::optional<double> number(std::size_t column) const;

  /// The field as a whole number, which some programs write 2.0; nothing if it is none.
  std::optional<long long> integer(std::size_t column) const;

  /// An error at the current row.
  Error error(const std::string& message) const { return rows_.error(message); }

  /// The file that is read.
  const std::string& file() const { return rows_.file(); }

  /// The number of the current row's first line, from 1.
  int line() const { return rows_.line(); }

 private:
  void find_columns();
  std::vector<std::size_t> places_in_row() const;
  Error header_error(const std::string& column, const std::vector<std::string>& names);
  RowFault structural_fault() const;

  CsvRows rows_;
  TableFormat format_;
  std::vector<std::size_t> places_;  ///< in the row, by column asked for
  std::size_t most_ = 0;             ///< of places_
  std::size_t named_ = 0;            ///< columns that the header names, 0 without header
  std::vector<std::string_view> fields_;
  RowFault fault_;
};

}  // namespace evbal

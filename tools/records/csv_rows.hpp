#pragma once

#include "tools/records/text_lines.hpp"

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// Splits the lines of one row into its fields, where some are in quotes (RFC 4180).
class QuotedRow {
 public:
  /// How a row stands after a line of it.
  enum class State {
    complete,
    open,   ///< within quotes: the next line belongs to the row
    stray,  ///< something follows a closing quote
  };

  /// `separator` as in CsvRows.
  explicit QuotedRow(char separator) : separator_(separator) {}

  /// Begins a row.
  State begin(std::string_view line);

  /// Goes on with it after begin() or go_on() said `open`.
  State go_on(std::string_view line);

  /// The fields so far, without quotes and without blanks around them; valid until the next call.
  void fields(std::vector<std::string_view>& into) const;

 private:
  void begin_field();
  State split(std::string_view rest);
  bool end_of_row(std::string_view rest, std::size_t end);

  char separator_;
  std::vector<std::string> fields_;
  std::size_t count_ = 0;
  bool quoted_ = false;
};

/// The rows of a table as other people's programs write them (RFC 4180): fields of any length, in quotes or not, line
/// breaks within quotes. Plain or compressed.
class CsvRows {
 public:
  /// Fields are parted by `separator`; a blank stands for any number of blanks and tabs. Throws as LineReader does.
  CsvRows(const std::filesystem::path& file, char separator);

  /// Skips a line, whatever is in it; false at the end of the file.
  bool skip_line();

  /// Moves to the next row that is not blank; false at the end.
  bool next();

  /// The fields of the row, without quotes and without blanks around them; valid until the next call.
  const std::vector<std::string_view>& fields() const { return fields_; }

  /// True if a quote of the row is not closed within a MiB from the second line on, or closed within a field, or if the
  /// row goes over several lines and has not as many fields as the first one. The row is then its first line alone, so
  /// that no other row is lost with it, and fields() means nothing.
  bool stray_quote() const { return stray_; }

  /// The row's first line as it stands in the file.
  const std::string& text() const { return row_; }

  /// The file that is read.
  const std::string& file() const { return lines_.file(); }

  /// The number of the row's first line, from 1.
  int line() const { return line_; }

  /// An error at the row's first line.
  Error error(const std::string& message) const;

 private:
  bool take_line();
  void split_plain();
  void split_quoted();

  LineReader lines_;
  char separator_;
  int line_ = 0;
  int lines_taken_ = 0;
  std::string row_;
  std::deque<std::string> ahead_;  ///< lines that were read but do not belong to the row
  QuotedRow quoted_;
  std::vector<std::string_view> fields_;
  std::size_t expected_ = 0;  ///< fields, as many as in the first row; 0 before it
  bool stray_ = false;
};

}  // namespace evbal

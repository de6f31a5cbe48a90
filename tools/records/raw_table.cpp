#include "tools/records/raw_table.hpp"

#include "agents/world/pack_table.hpp"
#include "common/plain_text.hpp"
#include "common/suggestion.hpp"
#include "tools/records/dropped.hpp"
#include "tools/records/raw_numbers.hpp"

#include <algorithm>

namespace evbal {
namespace {

constexpr int kLongestPreamble = 50;  // lines looked through for the header

/// A number that is written with a decimal comma as with a point; empty if it has a point, which groups thousands.
std::string with_point(std::string_view number) {
  std::string text(number.find('.') == std::string_view::npos ? number : std::string_view());
  std::replace(text.begin(), text.end(), ',', '.');
  return text;
}

}  // namespace

TableFormat read_table_format(YamlMap& map) {
  TableFormat format;
  if (const auto separator = map.find("separator")) {
    format.separator = std::string_view(",;\t ")[separator->one_of({"comma", "semicolon", "tab", "space"})];
  }
  if (const auto header = map.find("header")) {
    format.header = header->boolean();
  }
  if (const auto rows = map.find("skip_rows")) {
    format.skip_rows = rows->integer(0, 1'000'000);
  }
  if (const auto decimal = map.find("decimal")) {
    format.decimal_comma = decimal->one_of({"point", "comma"}) == 1;
  }
  return format;
}

std::size_t add_column(TableFormat& format, const YamlValue& value) {
  format.columns.push_back(format.header ? value.text() : std::to_string(value.integer(1, 1000)));
  return format.columns.size() - 1;
}

std::string column_name(const TableFormat& format, std::size_t column) {
  const std::string& name = format.columns[column];
  return format.header ? "`" + name + "`" : "column " + name;
}

RawTable::RawTable(const std::filesystem::path& file, const TableFormat& format)
    : rows_(file, format.separator), format_(format), fields_(format.columns.size()) {
  for (int line = 0; line < format_.skip_rows; ++line) {
    rows_.skip_line();
  }
  if (format_.header) {
    find_columns();
  } else {
    for (const auto& column : format_.columns) {
      places_.push_back(static_cast<std::size_t>(*parse_integer(column) - 1));
    }
  }
  most_ = places_.empty() ? 0 : *std::max_element(places_.begin(), places_.end());
}

void RawTable::find_columns() {
  if (!rows_.next()) {
    throw error("is empty; the first line must name the columns");
  }
  if (rows_.stray_quote()) {
    throw header_error(format_.columns.front(), {rows_.text()});
  }
  places_ = places_in_row();
  named_ = rows_.fields().size();
  for (std::size_t c = 0; c < places_.size(); ++c) {
    const std::string& column = format_.columns[c];
    if (places_[c] == named_) {
      throw header_error(column, {rows_.fields().begin(), rows_.fields().end()});
    }
    if (std::count(rows_.fields().begin(), rows_.fields().end(), column) > 1) {
      throw error("names the column `" + column + "` twice; which one is meant? Rename the other");
    }
  }
}

/// Where the row has the columns asked for; the number of its fields where it lacks one.
std::vector<std::size_t> RawTable::places_in_row() const {
  const auto& names = rows_.fields();
  std::vector<std::size_t> places;
  places.reserve(format_.columns.size());
  for (const auto& column : format_.columns) {
    places.push_back(static_cast<std::size_t>(std::find(names.begin(), names.end(), column) - names.begin()));
  }
  return places;
}

Error RawTable::header_error(const std::string& column, const std::vector<std::string>& names) {
  std::string all;
  std::vector<std::string> plain;  // names that a message may show
  for (const auto& name : names) {
    all += (all.empty() ? "" : ", ") + name;
    if (validate_line(name).empty()) {
      plain.push_back(name);
    }
  }
  const bool one = names.size() == 1 && all.find_first_of(",;\t") != std::string::npos;
  const char* why = rows_.stray_quote() ? "; its quotes do not pair"
                    : one               ? "; what is its `separator`?"
                                        : "; is the description of this table?";
  Error at_header =
      error("has no column `" + column + "`" + did_you_mean(column, plain) + "; it has " + shown(all) + why);
  for (int row = 0; row < kLongestPreamble && rows_.next(); ++row) {
    const auto places = places_in_row();
    if (!rows_.stray_quote() &&
        std::none_of(places.begin(), places.end(), [&](std::size_t p) { return p == rows_.fields().size(); })) {
      return bad_input(at_header.what() + std::string(" The columns are named in line ") +
                       std::to_string(rows_.line()) + ": give `skip_rows`, the number of lines before that one");
    }
  }
  return at_header;
}

bool RawTable::next() {
  if (!rows_.next()) {
    return false;
  }
  fault_ = structural_fault();
  for (std::size_t c = 0; !fault_ && c < places_.size(); ++c) {
    fields_[c] = rows_.fields()[places_[c]];
    if (fields_[c].find('\0') != std::string_view::npos) {
      fault_ = {"a NUL byte in a field", fields_[c]};
    }
  }
  return true;
}

RowFault RawTable::structural_fault() const {
  const auto& all = rows_.fields();
  if (rows_.stray_quote()) {
    return {"quotes that do not pair", rows_.text()};
  }
  if (all.size() <= most_) {
    return {"fewer columns than the description names", rows_.text()};
  }
  if (named_ > 0 && all.size() > named_ &&
      std::any_of(all.begin() + static_cast<std::ptrdiff_t>(named_), all.end(),
                  [](std::string_view field) { return !field.empty(); })) {
    return {"more fields than the header names", rows_.text()};
  }
  return {};
}

std::optional<double> RawTable::number(std::size_t column) const {
  return format_.decimal_comma ? raw_number(with_point(text(column))) : raw_number(text(column));
}

std::optional<long long> RawTable::integer(std::size_t column) const {
  return format_.decimal_comma ? raw_integer(with_point(text(column))) : raw_integer(text(column));
}

}  // namespace evbal

#include "tools/records/raw_table.hpp"

#include "agents/world/pack_table.hpp"
#include "common/table_text.hpp"

#include <algorithm>

namespace evbal {
namespace {

constexpr std::size_t kLongestLine = 1 << 16;
constexpr std::string_view kBlanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
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
  return format;
}

std::size_t add_column(TableFormat& format, const YamlValue& value) {
  format.columns.push_back(format.header ? value.text() : std::to_string(value.integer(1, 1000)));
  return format.columns.size() - 1;
}

RawTable::RawTable(const std::filesystem::path& file, const TableFormat& format)
    : lines_(file, kLongestLine), format_(format), fields_(format.columns.size()) {
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
  if (!lines_.next(line_)) {
    throw error("is empty; the first line must name the columns");
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line_.starts_with(kByteOrderMark)) {
    line_.erase(0, kByteOrderMark.size());
  }
  split();
  for (const auto& column : format_.columns) {
    const auto found = std::find(all_.begin(), all_.end(), column);
    if (found == all_.end()) {
      std::vector<std::string> names(all_.begin(), all_.end());
      throw error("has no column `" + column + "`" + did_you_mean(column, names) +
                  "; is the description of this table?");
    }
    places_.push_back(static_cast<std::size_t>(found - all_.begin()));
  }
}

void RawTable::split() {
  if (line_.find('"') != std::string::npos) {
    split_quoted();
    return;
  }
  all_.clear();
  std::string_view rest = line_;
  const std::string_view ends = format_.separator == ' ' ? kBlanks : std::string_view(&format_.separator, 1);
  for (std::size_t end = rest.find_first_of(ends); end != std::string_view::npos; end = rest.find_first_of(ends)) {
    if (format_.separator != ' ' || end > 0) {
      all_.push_back(trimmed(rest.substr(0, end)));
    }
    rest.remove_prefix(end + 1);
  }
  if (format_.separator != ' ' || !rest.empty()) {
    all_.push_back(trimmed(rest));
  }
}

void RawTable::split_quoted() {
  split_csv(line_, format_.separator, unquoted_);
  all_.clear();
  for (const auto& field : unquoted_) {
    all_.push_back(trimmed(field));
  }
}

bool RawTable::next() {
  do {
    if (!lines_.next(line_)) {
      return false;
    }
  } while (trimmed(line_).empty());
  split();
  whole_ = all_.size() > most_;
  for (std::size_t c = 0; whole_ && c < places_.size(); ++c) {
    fields_[c] = all_[places_[c]];
  }
  return true;
}

}  // namespace evbal

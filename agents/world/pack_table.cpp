#include "agents/world/pack_table.hpp"

#include "common/decimal.hpp"
#include "common/table_text.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

namespace evbal {

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  const bool whole = code == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

std::optional<long long> parse_integer(std::string_view text) {
  long long value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = code == std::errc{} && end == text.data() + text.size();
  return whole ? std::optional(value) : std::nullopt;
}

PackTable::PackTable(const std::filesystem::path& file, const std::string& header) : file_(file.string()) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw bad_input(file_, 0, "cannot be read; the pack needs this file");
  }
  std::ostringstream text;
  text << in.rdbuf();
  content_ = std::move(text).str();
  const auto first = next_line();
  if (!first || *first != header) {
    throw error("the first line must be `" + header + "`");
  }
  names_ = split_csv(header);
}

std::optional<std::string_view> PackTable::next_line() {
  ++line_;
  if (at_ == content_.size()) {
    return std::nullopt;
  }
  const std::size_t end = content_.find('\n', at_);
  if (end == std::string::npos) {
    throw error("the last line has no end; the file is truncated");
  }
  const std::string_view line = std::string_view(content_).substr(at_, end - at_);
  at_ = end + 1;
  return line;
}

bool PackTable::next() {
  const auto line = next_line();
  if (!line) {
    return false;
  }
  split_csv(*line, ',', fields_);
  if (fields_.size() != names_.size()) {
    throw error("has " + std::to_string(fields_.size()) + " fields, not " + std::to_string(names_.size()));
  }
  return true;
}

std::string_view PackTable::text(std::size_t column) const {
  return fields_[column];
}

int PackTable::integer(std::size_t column, int low, int high) const {
  const auto value = parse_integer(fields_[column]);
  if (!value || *value < low || *value > high) {
    throw error(names_[column] + " `" + fields_[column] + "` must be a whole number from " + std::to_string(low) +
                " to " + std::to_string(high));
  }
  return static_cast<int>(*value);
}

double PackTable::number(std::size_t column, double low, double high) const {
  const auto value = parse_number(fields_[column]);
  if (!value || *value < low || *value > high) {
    throw error(names_[column] + " `" + fields_[column] + "` must be a number from " + decimal(low) + " to " +
                decimal(high));
  }
  return *value;
}

Error PackTable::error(const std::string& message) const {
  return bad_input(file_, line_, message);
}

}  // namespace evbal

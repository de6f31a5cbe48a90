#include "tools/ingest/zone_ids.hpp"

#include <algorithm>

namespace evbal {

std::string trimmed_id(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == std::string_view::npos ? std::string()
                                         : std::string(text.substr(first, text.find_last_not_of(kBlanks) - first + 1));
}

std::optional<std::string> whole_number(std::string_view text, char decimal) {
  const bool negative = text.starts_with('-');
  text.remove_prefix(negative ? 1 : 0);
  const std::size_t point = text.find(decimal);
  const std::string_view whole = text.substr(0, point);
  const std::string_view rest = point == std::string_view::npos ? "0" : text.substr(point + 1);
  const bool digits = std::all_of(whole.begin(), whole.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (whole.empty() || !digits || rest.find_first_not_of('0') != std::string_view::npos) {
    return std::nullopt;
  }
  const std::size_t first = whole.find_first_not_of('0');
  if (first == std::string_view::npos) {
    return "0";
  }
  return (negative ? "-" : "") + std::string(whole.substr(first));
}

}  // namespace evbal

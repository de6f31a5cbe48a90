#include "tools/records/raw_numbers.hpp"

#include "agents/world/pack_table.hpp"

#include <charconv>
#include <cmath>

namespace evbal {

std::optional<double> raw_number(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = code == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

std::optional<long long> raw_integer(std::string_view text) {
  constexpr double kLargest = 9e15;  // up to which doubles tell whole numbers apart
  if (const auto whole = parse_integer(text)) {
    return whole;
  }
  const auto value = raw_number(text);
  if (!value || std::abs(*value) > kLargest || *value != std::floor(*value)) {
    return std::nullopt;
  }
  return static_cast<long long>(*value);
}

}  // namespace evbal

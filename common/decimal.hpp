#pragma once

#include <array>
#include <charconv>
#include <cstdio>
#include <string>
#include <type_traits>

namespace evbal {

/// The shortest decimal without an exponent that reads back as the same number.
template <class Number>
requires std::is_arithmetic_v<Number> std::string decimal(Number value) {
  std::array<char, 400> digits{};  // the smallest number has 326
  const auto first = digits.data();
  if constexpr (std::is_floating_point_v<Number>) {
    return {first, std::to_chars(first, first + digits.size(), value, std::chars_format::fixed).ptr};
  } else {
    return {first, std::to_chars(first, first + digits.size(), value).ptr};
  }
}

/// The number with `digits` after the point; `sign`: with + or - before it.
inline std::string fixed(double value, int digits, bool sign = false) {
  std::array<char, 400> text{};  // the largest number has 309 before the point
  std::snprintf(text.data(), text.size(), sign ? "%+.*f" : "%.*f", digits, value);
  return text.data();
}

}  // namespace evbal

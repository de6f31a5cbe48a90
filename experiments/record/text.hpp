#pragma once

#include <charconv>
#include <string>
#include <type_traits>

namespace evbal {

/// The shortest decimal that reads back as the same number.
template <class Number>
requires std::is_arithmetic_v<Number> std::string shortest(Number value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

}  // namespace evbal

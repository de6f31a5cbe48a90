#pragma once

#include <array>
#include <charconv>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

namespace evbal {

/// The shortest decimal that reads back as the same number.
template <class Number>
requires std::is_arithmetic_v<Number> std::string shortest(Number value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/// The parts of a line between separators.
std::vector<std::string> split(const std::string& line, char separator);

/// Throws Error{run_failed} if the file cannot be written.
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace evbal

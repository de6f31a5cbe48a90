#include "experiments/study/statistics/markdown.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace evbal {

std::string number(double value, int digits, bool sign) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), sign ? "%+.*f" : "%.*f", digits, value);
  return text.data();
}

std::string rounded(double value) {
  const double size = std::abs(value);
  return number(value, size >= 100.0 ? 0 : size >= 10.0 ? 1 : size >= 1.0 ? 2 : 3);
}

std::string range(const Interval& interval, double factor, int digits, bool sign) {
  return number(factor * interval.low, digits, sign) + " .. " + number(factor * interval.high, digits, sign);
}

std::string table_row(const Words& cells) {
  std::string row = "|";
  for (const auto& cell : cells) {
    row += " " + cell + " |";
  }
  return row + "\n";
}

std::string header(const Words& cells, std::size_t left) {
  std::string rule = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    rule += i < left ? "---|" : "--:|";
  }
  return table_row(cells) + rule + "\n";
}

bool contains(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace evbal

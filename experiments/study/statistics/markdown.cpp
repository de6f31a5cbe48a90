#include "experiments/study/statistics/markdown.hpp"

#include "common/decimal.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {

int digits_for(double size) {
  return size >= 100.0 ? 0 : size >= 10.0 ? 1 : size >= 1.0 ? 2 : 3;
}

std::string rounded(double value) {
  return fixed(value, digits_for(std::abs(value)));
}

std::string range(const Interval& interval, double factor, int digits, bool sign) {
  if (!is_known(interval)) {
    return "not known";
  }
  return fixed(factor * interval.low, digits, sign) + " .. " + fixed(factor * interval.high, digits, sign);
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

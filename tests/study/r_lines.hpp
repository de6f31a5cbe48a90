#pragma once

#include "tests/support/source_folder.hpp"

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace evbal::test {

/// The lines of a CSV file that an R script of the tests made: what kind of line each is, and its numbers.
inline std::vector<std::pair<std::string, std::vector<double>>> r_lines(const std::string& path) {
  std::vector<std::pair<std::string, std::vector<double>>> lines;
  std::ifstream file(in_source(path));
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::string kind;
    std::getline(cells, kind, ',');
    std::vector<double> numbers;
    for (std::string cell; std::getline(cells, cell, ',');) {
      numbers.push_back(std::stod(cell));
    }
    lines.emplace_back(kind, numbers);
  }
  return lines;
}

}  // namespace evbal::test

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace evbal {

/// The steps of a finished day of a sweep.
struct FinishedSteps {
  std::vector<std::string> starts;                     ///< "05:00"
  std::map<std::string, std::vector<double>> columns;  ///< those asked for
};

/// For each of the days that read_finished gives, in that order, these columns of steps.csv. Throws Error{bad_input} if
/// the file is no sweep or has no such column.
std::vector<FinishedSteps> read_finished_steps(const std::filesystem::path& file,
                                               const std::vector<std::string>& columns);

}  // namespace evbal

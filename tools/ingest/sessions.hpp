#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// Lengths of charging sessions, and how many rows were dropped and why.
struct SessionSample {
  std::vector<double> minutes;  ///< ascending
  long long read = 0;           ///< rows
  long long other_model = 0;    ///< rows of other chargers
  long long unfinished = 0;     ///< without a readable start or end
  long long out_of_range = 0;   ///< shorter or longer than asked for
};

/// Lengths of the charging sessions in every table of `folder` with a column `Model` that contains `model`, within
/// [shortest, longest] minutes. Dates as dd/mm/yyyy, times as hh:mm, in columns `Start Date`, `Start Time`, `End Date`,
/// `End Time`; tables without these columns are skipped. Throws Error{bad_input} if no session remains.
SessionSample read_sessions(const std::filesystem::path& folder, const std::string& model, double shortest,
                            double longest);

/// Quantiles of an ascending sample at probabilities 0, 1/(n-1), ..., 1, linear between order statistics.
std::vector<double> quantiles(const std::vector<double>& ascending, int n);

}  // namespace evbal

#pragma once

#include "tools/ingest/session_format.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// Which charging sessions are taken, whose lengths stand for those of a fleet.
struct SessionChoice {
  std::string model;      ///< word in the charger's model, if the table tells it
  double shortest = 0.0;  ///< minutes
  double longest = 0.0;   ///< minutes
};

/// Lengths of charging sessions.
struct SessionSample {
  std::vector<double> minutes;  ///< ascending
  std::string report;           ///< what was read, dropped and why; one item a line
};

/// Lengths of the sessions in every table of `folder` that has the columns of `format`; others are told in the report.
/// Throws Error{bad_input} with what was dropped, also if no session remains or no table has the columns.
SessionSample read_sessions(const std::filesystem::path& folder, const SessionFormat& format,
                            const SessionChoice& choice);

/// Quantiles of an ascending sample at probabilities 0, 1/(n-1), ..., 1, linear between order statistics.
std::vector<double> quantiles(const std::vector<double>& ascending, int n);

}  // namespace evbal

#pragma once

#include "agents/protocol/messages.hpp"
#include "common/eigen.hpp"
#include "experiments/record/recorded_fault.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace evbal {

/// A finished run as read back from its directory.
struct RecordedRun {
  std::filesystem::path folder;
  std::string scenario;
  std::string date;
  std::uint64_t seed = 0;
  std::string controller;
  std::string transport;
  std::string digest;
  std::string day_start;  ///< "05:00"
  int step_minutes = 0;
  int regions = 0;
  int fleet = 0;
  int solves = 0;
  int fallbacks = 0;
  double solve_seconds_median = 0.0;
  double wall_seconds = 0.0;
  std::map<std::string, double> totals;              ///< by metric
  std::map<std::string, std::vector<double>> steps;  ///< columns of steps.csv, but for `start`
  std::map<std::string, Eigen::MatrixXd> by_region;  ///< columns of regions.csv but for `start`, regions x steps
  int ticks = 0;
  std::vector<PlanCost> plan_costs;  ///< by term, the mean over the plans that were solved for
  std::vector<RecordedFault> faults;
};

/// Throws Error{bad_input} if `folder` holds no finished run.
RecordedRun read_run(const std::filesystem::path& folder);

/// The same of a run that has the mark INCOMPLETE because something is still to be added to its directory.
RecordedRun read_marked_run(const std::filesystem::path& folder);

}  // namespace evbal

#pragma once

#include "agents/protocol/messages.hpp"
#include "common/eigen.hpp"
#include "common/legs.hpp"
#include "experiments/record/recorded_fault.hpp"
#include "experiments/record/recorded_sensor.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace evbal {

/// A finished run as read back from its directory.
struct RecordedRun {
  std::filesystem::path folder;                      ///< of the run
  std::string scenario;                              ///< its name
  std::string date;                                  ///< of the day, ISO 8601
  std::uint64_t seed = 0;                            ///< of the run
  std::string controller;                            ///< its name
  std::string transport;                             ///< dds or inproc
  std::string digest;                                ///< of all that was said
  std::string day_start;                             ///< "05:00"
  int step_minutes = 0;                              ///< of the record
  int regions = 0;                                   ///< of the city
  int fleet = 0;                                     ///< vehicles
  int solves = 0;                                    ///< plans that were solved
  int fallbacks = 0;                                 ///< plans that fell back
  double solve_seconds_median = 0.0;                 ///< of a processor
  double wall_seconds = 0.0;                         ///< that the run took
  std::vector<ProcessLegs> timings;                  ///< what the legs of the ticks took, all agents as one
  std::map<std::string, double> totals;              ///< by metric
  std::map<std::string, std::vector<double>> steps;  ///< columns of steps.csv, but for `start`
  std::map<std::string, Eigen::MatrixXd> by_region;  ///< columns of regions.csv but for `start`, regions x steps
  int ticks = 0;                                     ///< of the day
  std::vector<PlanCost> plan_costs;                  ///< by term, the mean over the plans that were solved for
  std::vector<RecordedFault> faults;                 ///< in the order of the schedule
  std::vector<RecordedSensor> sensors;               ///< flagged by plans, at most eight
};

/// Throws Error{bad_input} if `folder` holds no finished run.
RecordedRun read_run(const std::filesystem::path& folder);

/// The same of a run that has the mark INCOMPLETE because something is still to be added to its directory.
RecordedRun read_marked_run(const std::filesystem::path& folder);

}  // namespace evbal

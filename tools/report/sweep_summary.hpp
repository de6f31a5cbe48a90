#pragma once

#include "experiments/study/statistics/comparison.hpp"
#include "experiments/study/statistics/intervals.hpp"
#include "experiments/study/statistics/primaries.hpp"
#include "experiments/study/store/finished_steps.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What a page shows of a finished sweep.
namespace evbal {

/// A metric in an hour of the day.
struct HourMean {
  int hour = 0;         ///< of the day
  Interval interval{};  ///< by Student's t, over days
};

/// One setting of a variant in one scenario under one schedule of faults.
struct SweptPoint {
  FinishedDay first;                                     ///< first of the days with this setting
  int pairs = 0;                                         ///< number of (day, seed) pairs
  std::map<std::string, double> means{};                 ///< of each total: over seeds within a day, then over days
  std::map<std::string, std::vector<HourMean>> hours{};  ///< of the columns of the steps
};

/// The points in the order of the sweep. `steps` are those of `days`.
std::vector<SweptPoint> swept_points(const std::vector<FinishedDay>& days, const std::vector<FinishedSteps>& steps);

/// A question, and its answer or why there is none.
struct Answer {
  Question question;             ///< that was asked
  std::vector<Compared> rows{};  ///< the answer
  /// The adjusted p value of each row that is a primary endpoint of the sweep's page.
  std::vector<std::optional<double>> p_holm{};
  std::string refused{};  ///< why there is none; empty if there is
};

/// What is asked about each of the `references`: lost passengers, both kinds of unfairness, charger wait and idle km.
/// If the reference has several settings, idle km are compared at equally many lost passengers, all else at equal idle
/// km. Each for the whole day and, where the totals know it, from 07:00 on. `primaries` are those of the sweep's page.
/// Throws Error{bad_input} if a reference is no variant.
std::vector<Answer> answers(const std::vector<FinishedDay>& days, const std::vector<std::string>& references,
                            const std::vector<PrimaryAnswer>& primaries);

}  // namespace evbal

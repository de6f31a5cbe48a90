#pragma once

#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/statistics/intervals.hpp"

#include <optional>
#include <string>
#include <vector>

/// Variants of a sweep side by side, paired: on the same days, seeds and faults. Seeds of a day are summed, then days
/// are the sample (docs/sweeps.md, Comparisons).
namespace evbal {

/// What is compared.
struct Question {
  std::string metric = "lost";      ///< such as lost
  std::string reference{};          ///< variant that the others are held against
  std::optional<std::string> at{};  ///< idle_km or lost, also `_after_7`, at whose equal values; none: whatever it is
  std::optional<std::string> bound{};  ///< variant with the least that is possible on a day, if days have one
};

/// The name under which the bound stands among the variants of a sweep.
inline constexpr const char* bound_variant = "bound";

/// Both sides on one day, over the costs that both cover, a seed.
struct ComparedDay {
  /// ISO 8601.
  std::string day;
  double value = 0.0;      ///< of the metric
  double reference = 0.0;  ///< the same of the reference
};

/// How a variant lies to the reference: its whole front, or one setting of it, which is held against the reference's
/// front at its own cost. On each day both are compared over the costs that both cover.
struct Compared {
  std::string scenario;               ///< its name
  std::string faults;                 ///< name of the schedule
  std::string variant;                ///< its name
  std::string settings{};             ///< that the variant varies, or in which it differs from the reference
  bool whole = false;                 ///< whether the row is of all of the variant's settings, which may be one
  int days = 0;                       ///< that could be compared; what follows `inside` is of these
  int apart = 0;                      ///< days on which the two have no costs in common
  int points = 0;                     ///< settings of the variant, counted on each day
  int inside = 0;                     ///< of these, points within the costs of the reference's front
  double from = 0.0;                  ///< mean over days of the least cost that both cover, a seed
  double to = 0.0;                    ///< likewise of the greatest
  double covered = 0.0;               ///< mean share of the reference's range
  double value = 0.0;                 ///< of what adds up over a day the sum over days and seeds, else the mean
  double reference = 0.0;             ///< the same of the reference
  bool relative = true;               ///< whether the difference is a ratio less 1, which the question alone decides
  Interval difference{};              ///< with its 95 % interval by t over days
  double p = 1.0;                     ///< of Student's t test, of this row alone
  std::optional<double> way{};        ///< share of the way from the reference to the bound, of days and seeds with one
  int way_days = 0;                   ///< of `days`, those of which some seed has a bound
  std::vector<ComparedDay> by_day{};  ///< the days that could be compared
};

/// A question and the rows that answer it.
struct AnsweredQuestion {
  Question question;           ///< that was asked
  std::vector<Compared> rows;  ///< the answer
};

/// value / reference - 1, of the totals; nothing if the row is not relative or there is nothing to divide by.
std::optional<double> of_totals(const Compared& row);

/// Compares every other variant with the reference, in each scenario and schedule of faults that both have: a row for
/// each setting of a variant that has several, then with Question::at a row for its whole front. Of a metric that adds
/// up over a day (adds_up) a day's result is the mean of ln((value + 1/2) / (reference + 1/2)), and the difference exp
/// of the days' mean less 1; of another metric, and against the bound, it is the plain difference. Throws
/// Error{bad_input} if a name is unknown, or without `at` if the reference has several settings. There is one day at
/// least.
std::vector<Compared> compare(const std::vector<FinishedDay>& days, const Question& question);

}  // namespace evbal

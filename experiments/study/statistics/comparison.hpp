#pragma once

#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/statistics/intervals.hpp"

#include <optional>
#include <string>
#include <vector>

/// Variants of a sweep side by side, paired: on the same days, seeds and faults.
namespace evbal {

/// What is compared.
struct Question {
  std::string metric;             ///< such as lost
  std::string reference;          ///< variant that the others are held against
  std::optional<std::string> at;  ///< metric, such as idle_km, at equal values of which the reference is taken
};

/// The answer for one setting of a variant, or for all of its settings together.
struct Compared {
  std::string scenario;     ///< its name
  std::string faults;       ///< name of the schedule
  std::string variant;      ///< its name
  std::string settings{};   ///< that the variant varies, or in which it differs from the reference; empty: all together
  int pairs = 0;            ///< (day, seed) pairs that could be compared; all below is of these
  int outside = 0;          ///< those whose point lies outside of the reference's front
  double at = 0.0;          ///< mean of Question::at
  double value = 0.0;       ///< mean of the metric
  double reference = 0.0;   ///< mean of the reference's metric, at equal cost if the question says so
  Interval difference{};    ///< of value - reference, by t
  bool relative = true;     ///< else the reference is 0 in some pair, and what follows is not known
  Interval by_t{};          ///< of the relative difference, value / reference - 1, pair by pair
  Interval by_bootstrap{};  ///< of the same
  double p = 1.0;       ///< of Student's t test of the relative difference, or of the difference if that is not known
  double p_holm = 1.0;  ///< the same, adjusted for all rows that are given together
};

/// Compares every other variant with the reference, on each (scenario, faults, day, seed) that both have. At equal cost
/// the reference's value is taken from its front, which are its settings on that day and seed, and never extrapolated;
/// together are then the mean over the settings that lie inside. Otherwise the reference must have one setting. Throws
/// Error{bad_input} if it has several, or if a name is unknown. There is one day at least.
std::vector<Compared> compare(const std::vector<FinishedDay>& days, const Question& question);

/// Adjusts the p values of rows that are read together.
void adjust(std::vector<Compared>& rows);

}  // namespace evbal

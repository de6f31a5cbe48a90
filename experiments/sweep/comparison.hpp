#pragma once

#include "experiments/metrics/intervals.hpp"
#include "experiments/sweep/sweep_file.hpp"

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
  std::string faults;
  std::string variant;
  std::string settings{};  ///< those that the variant varies; empty: all together
  int pairs = 0;           ///< (day, seed) pairs that could be compared; all below is of these
  int outside = 0;         ///< those whose point lies outside of the reference's front
  double at = 0.0;         ///< mean of Question::at
  double value = 0.0;      ///< mean of the metric
  double reference = 0.0;  ///< mean of the reference's metric, at equal cost if the question says so
  Interval by_t{};         ///< of the relative difference, value / reference - 1, pair by pair
  Interval by_bootstrap{};
};

/// Compares every other variant with the reference, on each (faults, day, seed). At equal cost the reference's value is
/// taken from its front, which are its settings on that day and seed, and never extrapolated; together are then the
/// mean over the settings that lie inside. Otherwise the reference must have one setting. Throws Error{bad_input} if it
/// has several, if a name is unknown, or if the reference's metric is 0 somewhere: no difference is relative to that.
std::vector<Compared> compare(const std::vector<FinishedDay>& days, const Question& question);

}  // namespace evbal

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace evbal {

/// A day of a sweep and what it came to.
struct FinishedDay {
  std::string scenario{};    ///< its name
  std::string variant;       ///< its name
  std::string controller{};  ///< its name
  std::string faults;        ///< name of the schedule
  /// ISO 8601.
  std::string day;
  std::uint64_t seed = 0;                         ///< of the run
  std::map<std::string, std::string> settings{};  ///< of the variant, by path
  std::map<std::string, double> totals{};         ///< by finished_metrics()
  std::string digest{};                           ///< of all that was said
};

/// The metrics that add up over a day's steps.
std::vector<std::string> additive_metrics();

/// The metrics of a day, and `_after_7` those that add up over its steps, of the steps from 07:00 on.
std::vector<std::string> finished_metrics();

}  // namespace evbal

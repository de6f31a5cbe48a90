#pragma once

#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/statistics/front.hpp"
#include "experiments/study/statistics/intervals.hpp"

#include <optional>
#include <string>
#include <vector>

/// Fronts of whole controllers side by side, day by day: a controller trades cost, such as idle km, for value, such as
/// lost passengers, so that one of its points alone says little.
namespace evbal {

/// How two fronts lie to each other over the costs that both cover.
struct FrontGap {
  double from = 0.0;       ///< cost
  double to = 0.0;         ///< cost, above `from`; or equal if one of the two is a frozen setting
  double log_ratio = 0.0;  ///< mean of ln((value + 1/2) / (reference + 1/2))
  double value = 0.0;      ///< mean
  double reference = 0.0;  ///< mean
  double covered = 0.0;    ///< share of the reference's costs
};

/// The gap between two lower hulls, exactly, as both are made of straight lines. Nothing if they have no range of costs
/// in common. `frozen`: one of them is a single setting, which is held against the other at its own cost.
std::optional<FrontGap> front_gap(const std::vector<FrontPoint>& hull, const std::vector<FrontPoint>& reference,
                                  bool frozen = false);

/// What is asked of fronts.
struct FrontQuestion {
  std::string metric = "lost";         ///< what is compared, never negative
  std::string reference{};             ///< variant that the others are held against
  std::string at = "idle_km";          ///< the cost
  std::optional<std::string> bound{};  ///< variant with the least that is possible on a day, if days have one
};

/// How a variant's fronts lie to the reference's. A day's front is made of its settings, each summed over the seeds
/// that both variants have, and the day's result is the mean over the costs that both fronts cover; days are the
/// sample.
struct ComparedFronts {
  std::string scenario;    ///< its name
  std::string faults;      ///< name of the schedule
  std::string variant;     ///< its name
  int days = 0;            ///< on which the fronts have a range in common; all below is of these
  int apart = 0;           ///< days on which they have none
  double covered = 0.0;    ///< mean share of the reference's range
  Interval ratio{};        ///< exp(mean of the days' log_ratio) - 1, with its interval by t
  double p = 1.0;          ///< of Student's t test of the days' log_ratio
  double value = 0.0;      ///< sum over days of the mean
  double reference = 0.0;  ///< the same of the reference; their ratio is the one of totals
  std::optional<double>
      way{};  ///< share of the way from the reference to the bound, of the days and seeds that have one
};

/// Every other variant, except the bound, against the reference, in each scenario and schedule of faults. Throws
/// Error{bad_input} if a name is unknown. There is one day at least.
std::vector<ComparedFronts> compare_fronts(const std::vector<FinishedDay>& days, const FrontQuestion& question);

}  // namespace evbal

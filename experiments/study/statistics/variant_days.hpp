#pragma once

#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/statistics/front.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// The days of one variant in one scenario under one schedule of faults, as a comparison reads them.
namespace evbal {

/// The days of `variants`, in the order of the sweep.
std::vector<FinishedDay> days_of(const std::vector<FinishedDay>& days, const std::vector<std::string>& variants);

/// What a comparison reads off a day.
struct ReadMetrics {
  std::string metric;    ///< that is compared
  std::string cost{};    ///< at whose equal values; empty: whatever it is
  std::string traded{};  ///< with `cost`, it tells which settings make the front
};

/// What a setting came to.
struct SettingTotals {
  double cost = 0.0;    ///< 0 if it is not asked for
  double traded = 0.0;  ///< likewise
  double metric = 0.0;  ///< that is compared
};

using Settings = std::map<std::string, std::string>;                     ///< by path, the controller too
using TotalsBySetting = std::map<Settings, std::vector<SettingTotals>>;  ///< several of a setting: corners of a bound
using SeedTotals = std::map<std::uint64_t, TotalsBySetting>;             ///< of a day
using VariantDays = std::map<std::string, SeedTotals>;                   ///< by date
using DayTotals = std::map<Settings, SettingTotals>;                     ///< of a day, seeds summed

/// The settings of a day, among which its controller.
Settings settings_of(const FinishedDay& day);

/// Adds a day.
void add_day(VariantDays& days, const FinishedDay& day, const ReadMetrics& read);

/// The seeds that both have.
std::vector<std::uint64_t> shared_seeds(const SeedTotals& first, const SeedTotals& second);

/// The settings that were played with all the seeds, each summed over these.
DayTotals summed(const SeedTotals& played, const std::vector<std::uint64_t>& seeds);

/// The front: the metric along the lower convex hull of cost and what is traded for it; without a cost, the points.
/// Metrics are divided by `divisor`.
std::vector<FrontPoint> front_of(const DayTotals& settings, double divisor);

/// The front of a bound, whose points are corners, over these seeds together, as far as `farthest`.
std::vector<FrontPoint> bound_front(const SeedTotals& bounds, const std::vector<std::uint64_t>& seeds, double farthest);

}  // namespace evbal

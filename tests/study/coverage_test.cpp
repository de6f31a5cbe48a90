#include "common/random.hpp"
#include "experiments/study/statistics/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace evbal {
namespace {

constexpr double true_effect = -0.2;  // mean over all days of ln(lost / the other's)

/// The days of a made-up study: fronts at four settings, levels that differ tenfold between days, Poisson counts. A
/// day's effect is spread by 0.3, half of its variance normal and half exponential, to the worse: as skewed as real
/// ones.
std::vector<FinishedDay> made_up_days(int count, std::uint64_t study) {
  std::vector<FinishedDay> days;
  for (int i = 0; i < count; ++i) {
    RandomStream random(study, Purpose::resampled_day, {.index = static_cast<std::uint64_t>(i)});
    const double level = 200.0 * std::exp(0.6 * random.normal());
    const double spread = 0.3 / std::sqrt(2.0);
    const double effect = true_effect + spread * random.normal() + spread * (random.exponential(1.0) - 1.0);
    for (const std::string variant : {"ref", "new"}) {
      for (int setting = 0; setting < 4; ++setting) {
        const double km = 10.0 + 4.0 * setting + random.uniform();
        const double mean = level * std::exp((variant == "new" ? effect : 0.0) - (km - 10.0) / 10.0);
        days.push_back({.scenario = "made-up",
                        .variant = variant,
                        .faults = "calm",
                        .day = std::to_string(i),
                        .seed = 1,
                        .settings = {{"price", std::to_string(setting)}},
                        .totals = {{"idle_km", km}, {"lost", static_cast<double>(random.poisson(mean))}}});
      }
    }
  }
  return days;
}

/// The share of studies, each of `days` days, whose interval holds the true effect.
double coverage(int days) {
  constexpr int studies = 1500;
  int held = 0;
  for (std::uint64_t study = 0; study < studies; ++study) {
    const Compared row =
        compare(made_up_days(days, study), {.metric = "lost", .reference = "ref", .at = "idle_km"}).back();
    held += row.difference.low <= std::expm1(true_effect) && std::expm1(true_effect) <= row.difference.high ? 1 : 0;
  }
  return static_cast<double>(held) / studies;
}

/// docs/sweeps.md has both figures.
TEST(Coverage, OfIntervalsOverTwentyOneDaysIsNearNinetyFivePerCent) {
  EXPECT_NEAR(coverage(21), 0.95, 0.02);
}

TEST(Coverage, OfIntervalsOverSevenDaysToo) {
  EXPECT_NEAR(coverage(7), 0.95, 0.02);
}

}  // namespace
}  // namespace evbal

#include "experiments/search/shrink.hpp"

#include "experiments/search/described.hpp"
#include "tests/search/ingredients_fixture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

using testing::harms_by;
using testing::made_up_harm;
using testing::made_up_harms;
using testing::small_ingredients;

struct ShrunkDraw {
  Ingredients ingredients;
  std::vector<Trial> trials;
  Trial small;

  bool enough(double harm) const { return harm >= 0.9 * trials.front().harm; }
};

/// A draw that does harm, made small.
ShrunkDraw shrunk_draw(std::uint64_t seed) {
  ShrunkDraw shrunk{.ingredients = small_ingredients(seed), .trials = {}, .small = {}};
  for (const auto& picks : random_draws(shrunk.ingredients, 20)) {
    if (made_up_harm(picks) > 0.0) {
      shrunk.trials = {{.number = 1, .stage = "draw", .picks = picks, .harm = made_up_harm(picks)}};
      break;
    }
  }
  shrunk.small = shrink(
      shrunk.ingredients, shrunk.trials.front(), [&](double harm) { return shrunk.enough(harm); }, made_up_harms,
      shrunk.trials);
  return shrunk;
}

RC_GTEST_PROP(Shrink, KeepsTheHarmAndTheGuard, (std::uint32_t seed)) {
  const ShrunkDraw shrunk = shrunk_draw(seed);
  RC_ASSERT(shrunk.enough(shrunk.small.harm));
  RC_ASSERT(shrunk.small.harm == made_up_harm(shrunk.small.picks));
  RC_ASSERT(keeps_guard(shrunk.small.picks, shrunk.ingredients));
  RC_ASSERT(shrunk.small.picks.size() <= shrunk.trials.front().picks.size());
  for (std::size_t i = 0; i < shrunk.trials.size(); ++i) {
    RC_ASSERT(shrunk.trials[i].number == i + 1);
  }
}

RC_GTEST_PROP(Shrink, LeavesNothingThatCouldGo, (std::uint32_t seed)) {
  const ShrunkDraw shrunk = shrunk_draw(seed);
  const int tick = shrunk.ingredients.context.clock.tick;
  const auto needed = [&](const Picks& less) { return !shrunk.enough(made_up_harm(less)); };
  for (std::size_t i = 0; i < shrunk.small.picks.size(); ++i) {
    const Fault& fault = shrunk.small.picks[i].fault;
    RC_ASSERT(shrunk.small.picks[i].entry != 2);  // jams do no harm
    for (std::size_t j = 0; j < fault.regions.size(); ++j) {
      Picks less = shrunk.small.picks;
      less[i].fault.regions.erase(less[i].fault.regions.begin() + static_cast<std::ptrdiff_t>(j));
      less[i].fault.magnitudes.erase(less[i].fault.magnitudes.begin() + static_cast<std::ptrdiff_t>(j));
      RC_ASSERT(needed(less));
    }
    const int minutes = tick * std::max(1, fault.duration / 8 / tick);
    if (fault.duration >= minutes + tick) {
      Picks less = shrunk.small.picks;
      less[i].fault.duration -= minutes;
      RC_ASSERT(needed(less));
      less[i].fault.start += minutes;
      RC_ASSERT(needed(less) || less[i].fault.start >= shrunk.ingredients.context.clock.minutes());
    }
    if (fault_type(fault.type).counts_points() && fault.magnitudes.front() > 1.0) {
      Picks less = shrunk.small.picks;
      for (double& points : less[i].fault.magnitudes) {
        points = std::max(1.0, points - std::max(1.0, std::floor(points / 8.0)));
      }
      RC_ASSERT(needed(less));
    }
  }
}

TEST(Shrink, TakesAwayFromFaultsThatLastBeyondTheDay) {
  const Ingredients ingredients = testing::ingredients_of(
      "  - {name: late, type: charger.outage, target: {regions: [3]}, start: \"23:30\", duration: 10h,\n"
      "     magnitude: {points: 6}}\n",
      "");
  const Harms one_each = harms_by([&](const Picks& picks) {
    for (const auto& pick : picks) {
      EXPECT_LT(pick.fault.start, ingredients.context.clock.minutes());
    }
    return static_cast<double>(picks.size());
  });
  std::vector<Trial> trials = {{.number = 1, .picks = random_draws(ingredients, 1).front(), .harm = 1.0}};
  const Trial small = shrink(
      ingredients, trials.front(), [](double harm) { return harm >= 0.9; }, one_each, trials);
  EXPECT_EQ(small.picks.front().fault.duration, 5);
  EXPECT_EQ(small.picks.front().fault.magnitudes, std::vector<double>{1.0});
}

TEST(Shrink, TriesAgainWhatCouldNotGoBefore) {
  const Ingredients ingredients = testing::ingredients_of(
      "  - {name: long, type: charger.outage, target: {regions: [3]}, start: \"10:00\", duration: 100min,\n"
      "     magnitude: {points: 1}}\n"
      "  - {name: other, type: process.pause, target: {agent: 1}, start: \"12:00\", duration: 5min}\n",
      "");
  // The other fault is needed for as long as the long one is long.
  const Harms harms_of = harms_by([](const Picks& picks) {
    const bool has_long = !picks.empty() && picks.front().entry == 0;
    return has_long && (picks.size() == 2 || picks.front().fault.duration <= 60) ? 1.0 : 0.0;
  });
  std::vector<Trial> trials = {{.number = 1, .picks = random_draws(ingredients, 1).front(), .harm = 1.0}};
  const Trial small = shrink(
      ingredients, trials.front(), [](double harm) { return harm >= 0.9; }, harms_of, trials);
  EXPECT_EQ(small.picks.size(), 1U);
  EXPECT_EQ(small.picks.front().fault.duration, 5);
}

TEST(Shrink, LetsAFaultGoWhileAnotherChanges) {
  const Ingredients ingredients = testing::ingredients_of(
      "  - {name: long, type: charger.outage, target: {regions: [3]}, start: \"10:00\",\n"
      "     duration: {uniform: {min: 30min, max: 2h}}, magnitude: {points: 1}}\n"
      "  - {name: short, type: process.pause, target: {agent: 1}, start: \"20:00\", duration: 25min}\n",
      "");
  const Harms minutes = harms_by([](const Picks& picks) {
    double harm = 0.0;
    for (const auto& pick : picks) {
      harm += pick.fault.duration;
    }
    return harm;
  });
  Picks picks = random_draws(ingredients, 1).front();
  picks.front().fault.duration = 70;
  std::vector<Trial> trials = {{.number = 1, .picks = picks, .harm = 95.0}};
  const Trial small = shrink(
      ingredients, trials.front(), [](double harm) { return harm >= 85.5; }, minutes, trials);
  EXPECT_EQ(small.picks.size(), 1U);
  EXPECT_GE(small.harm, 85.5);
}

TEST(Shrink, TakesFaultsAwayBeforeRegions) {
  const Ingredients ingredients = testing::ingredients_of(
      "  - {name: wide, type: charger.outage, target: {regions: [1, 3]}, start: \"10:00\", duration: 5min,\n"
      "     magnitude: {points: 1}}\n"
      "  - {name: small, type: process.pause, target: {agent: 1}, start: \"12:00\", duration: 5min}\n",
      "");
  // Region 1 is worth 5 of 100, the small fault 9: one of them may go.
  const Harms harms_of = harms_by([](const Picks& picks) {
    double harm = 0.0;
    for (const auto& pick : picks) {
      harm += pick.entry == 1                   ? 9.0
              : pick.fault.regions.size() == 2  ? 91.0
              : pick.fault.regions.front() == 3 ? 86.0
                                                : 5.0;
    }
    return harm;
  });
  std::vector<Trial> trials = {{.number = 1, .picks = random_draws(ingredients, 1).front(), .harm = 100.0}};
  const Trial small = shrink(
      ingredients, trials.front(), [](double harm) { return harm >= 90.0; }, harms_of, trials);
  EXPECT_EQ(small.harm, 91.0);
  ASSERT_EQ(small.picks.size(), 1U);
  EXPECT_EQ(small.picks.front().fault.regions, (std::vector<int>{1, 3}));
}

TEST(Described, SaysWhatWhereAndWhen) {
  const Schedule schedule = testing::read_text(testing::schedule_of(
      {testing::outage, testing::spike,
       "{name: slow, type: process.slow, target: {coordinator: true}, start: \"09:00\", duration: 1min, magnitude: "
       "2min"}));
  EXPECT_EQ(
      described(schedule, testing::small_context().clock),
      "charger.outage of 2 points in region 1 from 07:30 for 120 minutes, process.slow of 2 minutes of the "
      "coordinator from 09:00 for 1 minute and demand.scale by 1.80 in regions 0 and 2 from 17:30 for 90 minutes");
  EXPECT_EQ(described(Schedule{}, testing::small_context().clock), "no fault");
}

}  // namespace
}  // namespace evbal

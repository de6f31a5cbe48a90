#include "agents/region/sensors.hpp"

#include "agents/protocol/words.hpp"
#include "tests/region/plant_fixture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>

namespace evbal {
namespace {

constexpr int tick_minutes = 5;

Report truth_at(int tick) {
  Report truth;
  truth.tick = tick;
  truth.vacant = 10 + tick;
  truth.points = 4;
  return truth;
}

Effect lie(EffectType type, double magnitude = 0.0, ReportField field = ReportField::vacant) {
  return {.fault = 3, .type = type, .region = 0, .magnitude = magnitude, .field = field};
}

/// Reports at ticks 0, 2, 4, ... while `effect` acts from `first` up to, but not at, `last`: vacant cars said, less
/// those that are there.
std::vector<int> errors_under(const Effect& effect, int first, int last, int ticks) {
  SensorMemory memory;
  std::vector<int> errors;
  for (int tick = 0; tick < ticks; tick += 2) {
    const bool active = first <= tick && tick < last;
    const std::vector<Effect> effects = active ? std::vector<Effect>{effect} : std::vector<Effect>{};
    std::vector<Observed> observed(effects.size());
    const Report truth = truth_at(tick);
    const Report said = sensed(truth, effects, tick_minutes, 7, memory, observed);
    errors.push_back(said.vacant - truth.vacant);
    EXPECT_EQ(said.points, truth.points);
    EXPECT_EQ(active ? observed[0].amount : 0.0, errors.back());
  }
  return errors;
}

using Errors = std::vector<int>;

TEST(Sensors, SayWhatIsThere) {
  EXPECT_EQ(errors_under({}, 0, 0, 6), (Errors{0, 0, 0}));
}

TEST(Sensors, AreStuckAtTheFirstValueUntilTheFaultEnds) {
  EXPECT_EQ(errors_under(lie(EffectType::sensor_stuck), 2, 8, 12), (Errors{0, 0, -2, -4, 0, 0}));
}

TEST(Sensors, MayBeBiased) {
  EXPECT_EQ(errors_under(lie(EffectType::sensor_biased, -3.0), 2, 4, 6), (Errors{0, -3, 0}));
}

TEST(Sensors, LieOnEveryFieldThatIsMeasured) {
  for (std::size_t field = 1; field < enumerators<ReportField>; ++field) {
    SensorMemory memory;
    std::vector<Observed> observed(1);
    const auto which = static_cast<ReportField>(field);
    const Report said =
        sensed(truth_at(0), {lie(EffectType::sensor_biased, 5.0, which)}, tick_minutes, 7, memory, observed);
    const auto member = measured.at(index_of(which)).member;
    EXPECT_EQ(said.*member, truth_at(0).*member + 5) << word(which);
    EXPECT_EQ(measured.at(index_of(which)).name, word(which));
  }
}

TEST(Sensors, MayBeLate) {
  EXPECT_EQ(errors_under(lie(EffectType::sensor_delayed, 15.0), 0, 9, 10), (Errors{0, -2, -4, -4, -4}));
}

TEST(Sensors, MaySayNothing) {
  SensorMemory memory;
  std::vector<Observed> observed(1);
  const Effect off = lie(EffectType::sensor_off, 0.0, ReportField::points);
  EXPECT_EQ(sensed(truth_at(0), {off}, tick_minutes, 7, memory, observed).points, not_measured);
}

TEST(Sensors, MayBeNoisy) {
  const Errors errors = errors_under(lie(EffectType::sensor_noisy, 5.0), 0, 2000, 2000);
  double sum = 0.0;
  double squares = 0.0;
  for (const int error : errors) {
    sum += error;
    squares += static_cast<double>(error) * error;
  }
  EXPECT_NEAR(sum / 1000.0, 0.0, 0.5);
  EXPECT_NEAR(std::sqrt(squares / 1000.0), 5.0, 0.4);
}

TEST(Sensors, MaySayAnything) {
  SensorMemory memory;
  std::set<int> said;
  for (int tick = 0; tick < 100; ++tick) {
    std::vector<Observed> observed(1);
    said.insert(sensed(truth_at(tick), {lie(EffectType::sensor_garbage)}, tick_minutes, 7, memory, observed).vacant);
  }
  EXPECT_GT(said.size(), 90U);
  EXPECT_LT(*said.begin(), -1000);
  EXPECT_GT(*said.rbegin(), 1000000);
}

TEST(Sensors, DoNotTouchThePlant) {
  const World world = test::two_regions(1);
  const auto day = [&](std::vector<Effect> effects) {
    test::Life life{test::plant_of(world, 0, {}, {test::car(0, 9.0), test::car(1, 8.0)})};
    life.begin(std::move(effects));
    const Report said = life.plant.report();
    return std::pair(said.vacant, life.plant.live(nullptr).vacant);
  };
  EXPECT_EQ(day({}), std::pair(2, 2));
  EXPECT_EQ(day({lie(EffectType::sensor_biased, 40.0)}), std::pair(42, 2));
}

}  // namespace
}  // namespace evbal

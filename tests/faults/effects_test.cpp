#include "tests/faults/schedule_fixture.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

const DayClock usual_clock;  // ticks of 5 minutes from 05:00

Schedule with(Fault fault) {
  return {.seed = 0, .guard = {}, .faults = {std::move(fault)}};
}

Fault spike_of(int start, int duration, int ramp) {
  return {.name = "spike", .regions = {2}, .magnitudes = {3.0}, .start = start, .duration = duration, .ramp = ramp};
}

/// Factor on demand in each of the first ticks, 1 where no effect is active.
std::vector<double> factors(const Fault& fault, int ticks) {
  std::vector<double> values;
  for (int tick = 0; tick < ticks; ++tick) {
    const auto faults = faults_at(with(fault), usual_clock, tick);
    EXPECT_EQ(faults.tick, tick);
    values.push_back(faults.effects.empty() ? 1.0 : faults.effects.at(0).magnitude);
  }
  return values;
}

TEST(Effects, LastFromStartToEnd) {
  EXPECT_EQ(factors(spike_of(5, 10, 0), 5), (std::vector<double>{1, 3, 3, 1, 1}));
}

TEST(Effects, ActInTheNearestTicks) {
  EXPECT_EQ(factors(spike_of(7, 10, 0), 5), (std::vector<double>{1, 3, 3, 1, 1}));
  EXPECT_EQ(factors(spike_of(8, 10, 0), 5), (std::vector<double>{1, 1, 3, 3, 1}));
}

TEST(Effects, ActInOneTickAtLeast) {
  EXPECT_EQ(factors(spike_of(6, 1, 0), 4), (std::vector<double>{1, 3, 1, 1}));
  const auto last = faults_at(with(spike_of(usual_clock.minutes() - 1, 1, 0)), usual_clock, usual_clock.ticks() - 1);
  EXPECT_EQ(last.effects.size(), 1U);
}

TEST(Effects, RiseAndFallLinearly) {
  EXPECT_EQ(factors(spike_of(0, 30, 10), 7), (std::vector<double>{1.5, 2.5, 3, 3, 2.5, 1.5, 1}));
}

TEST(Effects, SayHowLongAProcessIsAway) {
  Fault kill = spike_of(10, 15, 0);
  kill.type = EffectType::process_kill;
  kill.magnitudes = {0.0};
  EXPECT_EQ(factors(kill, 6), (std::vector<double>{1, 1, 3, 2, 1, 1}));
  EXPECT_TRUE(faults_at(with(kill), usual_clock, 5).effects.empty());
}

TEST(Effects, ComeByFaultAndRegion) {
  Schedule schedule;
  schedule.faults.push_back(spike_of(0, 10, 0));
  schedule.faults.push_back({.name = "outage",
                             .type = EffectType::charger_outage,
                             .regions = {1, 3},
                             .magnitudes = {4, 7},
                             .start = 0,
                             .duration = 5,
                             .on_start = OnStart::evict,
                             .visible = false});
  const auto effects = faults_at(schedule, usual_clock, 0).effects;
  ASSERT_EQ(effects.size(), 3U);
  EXPECT_EQ(effects[0].region, 2);
  EXPECT_EQ(effects[1].fault, 1);
  EXPECT_EQ(effects[1].region, 1);
  EXPECT_EQ(effects[1].magnitude, 4.0);
  EXPECT_EQ(effects[1].on_start, OnStart::evict);
  EXPECT_FALSE(effects[1].visible);
  EXPECT_EQ(effects[2].region, 3);
  EXPECT_EQ(effects[2].magnitude, 7.0);
  EXPECT_EQ(faults_at(schedule, usual_clock, 1).effects.size(), 1U);
}

}  // namespace
}  // namespace evbal

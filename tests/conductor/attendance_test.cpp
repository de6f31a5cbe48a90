#include "experiments/conductor/attendance.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

using Regions = std::set<int>;

constexpr RunShape seven_regions{.seed = 1, .regions = 7, .regions_per_process = 3};

Effect effect_at(EffectType type, int region, double magnitude = 0.0) {
  Effect effect;
  effect.fault = 5;
  effect.type = type;
  effect.region = region;
  effect.magnitude = magnitude;
  return effect;
}

Effect effect_at(EffectType type, ProcessRole process, double magnitude = 0.0) {
  Effect effect = effect_at(type, no_region, magnitude);
  effect.process = process;
  return effect;
}

Effect on_topic(EffectType type, NetworkTopic topic, double magnitude) {
  Effect effect = effect_at(type, 2, magnitude);
  effect.topic = topic;
  return effect;
}

Attendance attendance_of(const Effect& effect, bool plan_due = true) {
  return attendance({effect}, seven_regions, 4, plan_due);
}

TEST(Attendance, IsFullWithoutFaults) {
  const Attendance all = attendance({effect_at(EffectType::demand_scale, 2, 3.0)}, seven_regions, 4, true);
  EXPECT_TRUE(all.away.empty() && all.absent.empty() && all.unheard.empty() && all.unplanned.empty());
  EXPECT_TRUE(all.seen.empty());
}

TEST(Attendance, AKilledAgentTakesItsProcessWithIt) {
  const Attendance kill = attendance_of(effect_at(EffectType::process_kill, 4, 6.0));
  EXPECT_EQ(kill.away, (Absences{{"agent-1", Absence::killed}}));
  EXPECT_EQ(kill.absent, (Regions{3, 4, 5}));
  ASSERT_EQ(kill.seen.size(), 1U);
  EXPECT_EQ(kill.seen[0].region, 4);
  EXPECT_EQ(kill.seen[0].observed.fault, 5);
  EXPECT_EQ(kill.seen[0].observed.amount, 1.0);
  EXPECT_EQ(attendance_of(effect_at(EffectType::process_pause, 6)).absent, Regions{6});
}

TEST(Attendance, OneProcessIsKilledRatherThanPaused) {
  const std::vector<Effect> both = {effect_at(EffectType::process_kill, 3), effect_at(EffectType::process_pause, 4)};
  EXPECT_EQ(attendance(both, seven_regions, 0, false).away, (Absences{{"agent-1", Absence::killed}}));
  EXPECT_EQ(attendance({both[1], both[0]}, seven_regions, 0, false).away, (Absences{{"agent-1", Absence::killed}}));
}

TEST(Attendance, CoordinatorAndInjectorHaveNoRegions) {
  const Attendance coordinator = attendance_of(effect_at(EffectType::process_pause, ProcessRole::coordinator));
  EXPECT_FALSE(coordinator.coordinator());
  EXPECT_TRUE(coordinator.absent.empty());
  const Attendance injector = attendance_of(effect_at(EffectType::process_kill, ProcessRole::injector));
  EXPECT_EQ(injector.away, (Absences{{"faults", Absence::killed}}));
}

TEST(Attendance, NobodyWaitsForWhoIsSlowerThanTheDeadline) {
  EXPECT_TRUE(attendance_of(effect_at(EffectType::process_slow, 0, report_deadline)).unheard.empty());
  const Attendance late = attendance_of(effect_at(EffectType::process_slow, 0, 1.5));
  EXPECT_EQ(late.unheard, (Regions{0, 1, 2}));
  EXPECT_EQ(late.unplanned, late.unheard);
  EXPECT_TRUE(late.absent.empty());
  EXPECT_EQ(attendance_of(effect_at(EffectType::process_slow, ProcessRole::coordinator, 2.0)).unplanned.size(), 7U);
  EXPECT_TRUE(attendance_of(effect_at(EffectType::process_slow, 0, 9.0), false).unheard.empty()) << "nothing is said";
}

TEST(Attendance, TheNetworkLosesSamplesOfATopic) {
  const Attendance report = attendance_of(on_topic(EffectType::network_delay, NetworkTopic::report, 3.0));
  EXPECT_EQ(report.unheard, Regions{2});
  EXPECT_TRUE(report.unplanned.empty());
  const Attendance plan = attendance_of(on_topic(EffectType::network_delay, NetworkTopic::plan, 3.0));
  EXPECT_TRUE(plan.unheard.empty());
  EXPECT_EQ(plan.unplanned, Regions{2});
  const Attendance parted = attendance_of(effect_at(EffectType::network_partition, 2));
  EXPECT_EQ(parted.unheard, Regions{2});
  EXPECT_EQ(parted.unplanned, Regions{2});
  EXPECT_EQ(parted.seen.at(0).observed.amount, 2.0);
  EXPECT_TRUE(attendance_of(on_topic(EffectType::network_delay, NetworkTopic::all, 1.0)).unheard.empty());
}

TEST(Attendance, DropsAreDrawnFromTheSeed) {
  const std::vector<Effect> drop = {on_topic(EffectType::network_drop, NetworkTopic::all, 0.3)};
  int lost = 0;
  int both = 0;
  for (int tick = 0; tick < 2000; ++tick) {
    const Attendance once = attendance(drop, seven_regions, tick, true);
    const Attendance twice = attendance(drop, seven_regions, tick, true);
    EXPECT_EQ(once.unheard, twice.unheard);
    EXPECT_EQ(once.unplanned, twice.unplanned);
    lost += static_cast<int>(once.seen.at(0).observed.amount);
    both += once.unheard.empty() || once.unplanned.empty() ? 0 : 1;
  }
  EXPECT_NEAR(lost / 4000.0, 0.3, 0.03);
  EXPECT_NEAR(both / 2000.0, 0.09, 0.03) << "report and plan are drawn apart";
}

}  // namespace
}  // namespace evbal

#include "experiments/metrics/detection.hpp"

#include "tests/record/small_day.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// Two regions for three hours, a plan every ten minutes; region 1's `vacant` is under a sensor fault from minute 30 to
/// 90, and first false at minute 40.
std::vector<TickRecord> lying_day() {
  std::vector<TickRecord> ticks(36);
  for (int t = 0; t < 36; ++t) {
    TickRecord& record = ticks[static_cast<std::size_t>(t)];
    record.tick.tick = t;
    record.exchange.departures = {small_departures(t, 0), small_departures(t, 1)};
    if (t % 2 == 0) {
      record.exchange.plan = small_plan(t);
    }
    if (t >= 6 && t < 18) {
      record.faults.effects = {
          {.fault = 0, .type = EffectType::sensor_biased, .region = 1, .field = ReportField::vacant}};
      record.exchange.departures[1].observed = {{.fault = 0, .amount = t >= 8 ? 3.0 : 0.0}};
    }
  }
  return ticks;
}

void flag(std::vector<TickRecord>& ticks, int minute, int region, ReportField field) {
  ticks[static_cast<std::size_t>(minute / 5)].exchange.plan->provenance.flags.push_back(
      {.region = region, .field = field});
}

const DayClock clock{.tick = 5, .step = 30, .plan_every = 10};

TEST(Detection, CountsFromTheFirstFalseReport) {
  auto ticks = lying_day();
  EXPECT_EQ(detection(clock, ticks).lies, 1);
  EXPECT_EQ(detection(clock, ticks).found, 0);
  flag(ticks, 60, 1, ReportField::demand);
  Detection is = detection(clock, ticks);
  EXPECT_EQ(is.seen_60, 1);
  EXPECT_EQ(is.found_60, 0);
  flag(ticks, 80, 1, ReportField::vacant);
  is = detection(clock, ticks);
  EXPECT_EQ(is.found, 1);
  EXPECT_EQ(is.found_60, 1);
  EXPECT_EQ(is.found_30, 0);
  EXPECT_EQ(is.minutes, 40);
  EXPECT_EQ(is.false_alarms, 0);
}

TEST(Detection, TellsLargeLiesByTheirFirstHour) {
  auto ticks = lying_day();
  flag(ticks, 80, 1, ReportField::vacant);
  EXPECT_EQ(detection(clock, ticks).large, 0);
  ticks[12].exchange.departures[1].observed.front().amount = -5.0;
  EXPECT_EQ(detection(clock, ticks).large, 1);
  EXPECT_EQ(detection(clock, ticks).large_found_60, 1);
}

TEST(Detection, CallsFlagsFalseWhereNothingLies) {
  auto ticks = lying_day();
  for (const int minute : {50, 60, 100}) {
    flag(ticks, minute, 0, ReportField::vacant);  // twice: from 50 to 60, and at 100
  }
  flag(ticks, 20, 1, ReportField::vacant);   // before the lie
  flag(ticks, 140, 1, ReportField::vacant);  // within an hour after it
  flag(ticks, 170, 1, ReportField::vacant);  // later
  EXPECT_EQ(detection(clock, ticks).false_alarms, 4);
}

TEST(Detection, ForgetsASensorThatToldTheTruth) {
  auto ticks = lying_day();
  for (TickRecord& record : ticks) {
    record.exchange.departures[1].observed.clear();
  }
  EXPECT_EQ(detection(clock, ticks).lies, 0);
}

}  // namespace
}  // namespace evbal

#include "experiments/metrics/metrics.hpp"

#include "tests/record/small_day.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

DayMetrics measured(const std::vector<TickRecord>& day) {
  return measure(small_header().frame, day);
}

TEST(Unfairness, IsWorkedOutByHand) {
  const std::vector<double> demand = {6, 2, 0};
  const std::vector<double> supply = {2, 0, 2};
  const std::vector<double> drop_offs = {0, 5, 0};
  const std::vector<double> completions = {3, 0, 1};
  const std::vector<double> low_battery = {1, 9, 3};
  const std::vector<int> points = {2, 0, 1};
  const Unfairness u = unfairness({demand, supply, drop_offs, completions, low_battery, points});
  EXPECT_DOUBLE_EQ(u.demand, 1 + 0 + 2);                 // ratios 3, 2 (of max(0, 1)), 0; the city's is 8 / 4
  EXPECT_DOUBLE_EQ(u.demand_shares, 0.25 + 0.25 + 0.5);  // 3/4 - 1/2, 1/4 - 0, 0 - 1/2
  const double city = 8.0 / 7.0;                         // supply with drop-offs 2, 3, 2
  EXPECT_DOUBLE_EQ(u.demand_drop_offs, (3 - city) + (city - 2.0 / 3.0) + city);
  EXPECT_DOUBLE_EQ(u.charging, 2 + 2.0 / 3.0);     // ratios 3 and 1/3; the stations' is 4 / 4
  EXPECT_DOUBLE_EQ(u.charging_shares, 0.5 + 0.5);  // 3/4 - 1/4, 1/4 - 3/4
}

TEST(Unfairness, OfNothingIsZero) {
  const std::vector<double> none = {0, 0};
  const std::vector<int> points = {1, 1};
  const Unfairness u = unfairness({none, none, none, none, none, points});
  EXPECT_EQ(u.demand, 0.0);
  EXPECT_EQ(u.demand_shares, 0.0);
  EXPECT_EQ(u.charging, 0.0);
}

TEST(Metrics, CountASmallDay) {
  const DayMetrics day = measured(small_day());
  ASSERT_EQ(day.steps.size(), 2);
  ASSERT_EQ(day.regions.size(), 4);
  EXPECT_TRUE(day.fleet_conserved);
  EXPECT_EQ(day.steps[0].flows.demand, 5);
  EXPECT_EQ(day.steps[0].flows.served, 1);
  EXPECT_EQ(day.steps[0].flows.lost, 1);
  EXPECT_EQ(day.steps[1].flows.lost, 1);
  EXPECT_EQ(day.steps[0].flows.rebalance_moves, 1);
  EXPECT_EQ(day.steps[0].idle_km, 4.0);
  EXPECT_EQ(day.steps[0].flows.passenger_km, 4.5);
  EXPECT_EQ(day.steps[1].flows.charge_km, 2.0);
  EXPECT_EQ(day.steps[1].idle_km, 1.0);  // beta is 0.5
  EXPECT_EQ(day.steps[0].stocks.vacant, 5);
  EXPECT_EQ(day.steps[0].under_way, 0);
  EXPECT_EQ(day.regions[1].flows.completions, 1);
  EXPECT_EQ(day.regions[1].stocks.points, 2);
}

TEST(Metrics, TakeSupplyAfterTheExecutedDispatch) {
  const DayMetrics day = measured(small_day());
  EXPECT_EQ(day.regions[0].supply, 2.0);  // 3 less the one that was sent off
  EXPECT_EQ(day.regions[1].supply, 2.0);
  EXPECT_EQ(day.regions[2].low_battery_present, 1.0);
  EXPECT_EQ(day.regions[3].low_battery_present, 0.0);
  // demand 4 and 1 over supply 2 and 2, the city's 5 / 4; completions 1 of 1 low-battery car: fair.
  EXPECT_DOUBLE_EQ(day.steps[0].unfairness.demand, 0.75 + 0.75);
  EXPECT_DOUBLE_EQ(day.steps[0].unfairness.charging, 0.0);
  // One drop-off in region 1 within the first window.
  EXPECT_DOUBLE_EQ(day.steps[0].unfairness.demand_drop_offs, (2.0 - 5.0 / 4.6) + (5.0 / 4.6 - 1.0 / 2.6));
}

TEST(Metrics, CountWhoTopsUpAsLowBattery) {
  auto day = small_day();
  day[2].exchange.departures[1].topped_up = 2;
  const DayMetrics measured_day = measured(day);
  EXPECT_EQ(measured_day.totals.flows.top_ups, 2);
  EXPECT_EQ(measured_day.regions[3].supply, measured(small_day()).regions[3].supply - 2.0);
  EXPECT_EQ(measured_day.regions[3].low_battery_present, measured(small_day()).regions[3].low_battery_present + 2.0);
}

TEST(Metrics, TotalsOfASmallDay) {
  const Totals totals = measured(small_day()).totals;
  EXPECT_EQ(totals.idle_km, 5.0);
  EXPECT_DOUBLE_EQ(totals.unserved_ratio, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(totals.p90_regional_loss, 2.0 / 3.0);  // nobody is settled in region 1
  EXPECT_EQ(totals.passenger_wait_min, 2.0);
  EXPECT_EQ(totals.charger_wait_min, 5.0);
  EXPECT_EQ(totals.charger_wait_min_per_session, 5.0);
  EXPECT_EQ(totals.idle_km_per_served, 5.0);
  EXPECT_DOUBLE_EQ(totals.unfairness.demand, 1.5);
}

TEST(Metrics, SeeALostVehicle) {
  auto day = small_day();
  day[2].exchange.departures[1].vacant -= 1;
  EXPECT_FALSE(measured(day).fleet_conserved);
}

TEST(Metrics, DoNotBelieveReports) {
  auto day = small_day();
  day[2].exchange.reports[1].vacant = 99;
  day[2].exchange.reports[1].low_battery = -1;
  EXPECT_EQ(measured(day).regions[3].supply, measured(small_day()).regions[3].supply);
  EXPECT_EQ(measured(day).regions[3].low_battery_present, measured(small_day()).regions[3].low_battery_present);
  day[2].exchange.departures[1].observed = {{.fault = 0, .amount = 1.0, .evicted = 2}};
  day[2].exchange.departures[1].broken = 1;
  EXPECT_EQ(measured(day).regions[3].supply, measured(small_day()).regions[3].supply - 1.0);
  EXPECT_EQ(measured(day).regions[3].low_battery_present, measured(small_day()).regions[3].low_battery_present + 2.0);
}

TEST(Metrics, AWindowPastTheLastTickIsLeftOut) {
  auto day = small_day();
  auto frame = small_header().frame;
  frame.clock.plan_every = 5;
  day[3].tick.plan_due = true;
  day[2].exchange.departures[0].vacant = 50;
  EXPECT_EQ(measure(frame, day).steps[1].unfairness.demand, measured(small_day()).steps[1].unfairness.demand);
  EXPECT_EQ(measure(frame, day).regions[2].supply, (1.0 + 50.0) / 2.0);
}

TEST(Metrics, HaveNames) {
  const auto names = metric_names();
  for (const char* name : {"served", "lost", "idle_km", "unfairness_demand", "unfairness_charging", "charger_wait_min",
                           "unserved_ratio"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

}  // namespace
}  // namespace evbal

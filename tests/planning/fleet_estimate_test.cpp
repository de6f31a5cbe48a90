#include "coordinator/planning/fleet_estimate.hpp"

#include "tests/planning/small_city.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

constexpr int step = 30;

FleetEstimate small_estimate() {
  const City city = testing::small_city();
  return FleetEstimate({city.points().cast<double>(), city.minutes, step, 45.0});
}

std::vector<std::optional<Report>> all_with(int vacant, int low_battery) {
  std::vector<std::optional<Report>> reports(3);
  for (int i = 0; i < 3; ++i) {
    Report report;
    report.region = i;
    report.vacant = vacant;
    report.low_battery = low_battery;
    report.points = testing::small_city().points()(i);
    reports[static_cast<std::size_t>(i)] = report;
  }
  return reports;
}

const std::vector<std::optional<Report>> silence(3);

TEST(FleetEstimate, PassesOnWhatIsReported) {
  FleetEstimate estimate = small_estimate();
  const auto reports = estimate.settle(0, all_with(7, 1));
  EXPECT_EQ(reports[2].vacant, 7);
  EXPECT_EQ(estimate.variance(), Eigen::VectorXd::Zero(3));
}

TEST(FleetEstimate, FollowsTheModelAndThePlans) {
  FleetEstimate estimate = small_estimate();
  estimate.settle(0, all_with(30, 1));
  // Region 0 sends 12 to region 1, 10 minutes away; of its other 18 a third of a half-step's share leaves.
  estimate.advance(10, {{0, 1, 12, Errand::rebalance}}, testing::simple_transitions());
  const auto early = estimate.settle(2, silence);
  EXPECT_EQ(early[0].vacant, 15);
  EXPECT_EQ(early[1].vacant, 25) << "the cars arrive at minute 10, not before";
  EXPECT_EQ(early[1].bound.at(0).count, 12);
  EXPECT_EQ(early[0].plugged, 2) << "the waiting car, and one of those that ran low: two points";
  EXPECT_EQ(early[2].low_battery, 2) << "no points in region 2";
  estimate.advance(20, {}, testing::simple_transitions());
  const auto late = estimate.settle(4, silence);
  EXPECT_GE(late[1].vacant, 25 + 12 - 5);
  EXPECT_GT(estimate.variance()(0), 0.0);
}

TEST(FleetEstimate, LosesNoVehicle) {
  FleetEstimate estimate = small_estimate();
  estimate.settle(0, all_with(40, 5));
  for (int minute = 10; minute <= 120; minute += 10) {
    estimate.advance(minute, {{0, 2, 3, Errand::rebalance}, {2, 0, 1, Errand::charge}}, testing::simple_transitions());
    int vehicles = 0;
    for (const Report& report : estimate.settle(minute / 5, silence)) {
      vehicles += report.vacant + report.low_battery + report.plugged;
      EXPECT_EQ(static_cast<int>(report.plugged_since.size()), report.plugged);
      for (const UnderWay& cars : report.bound) {
        vehicles += cars.count;
      }
    }
    EXPECT_NEAR(vehicles, 3 * 45, 8) << "by rounding";
  }
}

TEST(FleetEstimate, TakesWhoTopsUpForPluggedIn) {
  FleetEstimate estimate = small_estimate();
  auto heard = all_with(30, 0);
  heard[0]->chargeable = 28;
  heard[0]->reach_m = {};
  estimate.settle(0, heard);
  estimate.advance(0, {{0, 0, 2, Errand::charge}}, testing::simple_transitions());
  const auto reports = estimate.settle(2, silence);
  EXPECT_EQ(reports[0].vacant, 28);
  EXPECT_EQ(reports[0].plugged, 2);
  EXPECT_EQ(reports[0].chargeable, 28);
  EXPECT_TRUE(reports[0].bound.empty());
}

// What stands in for a report must not be one that cannot be true.
TEST(FleetEstimate, KeepsCountsThatFitTogether) {
  FleetEstimate estimate = small_estimate();
  auto heard = all_with(30, 4);
  for (auto& report : heard) {
    report->chargeable = 30;
    report->reach_m = {100, 200, 300, 400};
  }
  estimate.settle(0, heard);
  for (int minute = 10; minute <= 60; minute += 10) {
    estimate.advance(minute, {{0, 1, 25, Errand::rebalance}}, testing::simple_transitions());
    for (const Report& report : estimate.settle(minute / 5, silence)) {
      EXPECT_LE(report.chargeable, report.vacant);
      EXPECT_LE(static_cast<int>(report.reach_m.size()), report.low_battery);
    }
  }
}

TEST(FleetEstimate, KnowsLessTheLongerItHearsNothing) {
  FleetEstimate estimate = small_estimate();
  estimate.settle(0, all_with(10, 0));
  double before = 0.0;
  for (int minute = 10; minute <= 60; minute += 10) {
    estimate.advance(minute, {}, testing::simple_transitions());
    estimate.settle(minute / 5, silence);
    EXPECT_GT(estimate.variance()(1), before);
    before = estimate.variance()(1);
  }
  estimate.settle(14, all_with(10, 0));
  EXPECT_EQ(estimate.variance()(1), 0.0);
}

}  // namespace
}  // namespace evbal

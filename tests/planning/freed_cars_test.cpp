#include "coordinator/planning/freed_cars.hpp"

#include "tests/planning/small_city.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace evbal {
namespace {

constexpr int now = 100;
const std::vector<double> sessions{20.0, 40.0, 60.0};

// Three regions without cars and passengers; a tenth comes out low on battery.
PlanningData quiet_data() {
  PlanningData data;
  data.km = testing::small_city().km;
  data.minutes = testing::small_city().minutes;
  data.state.vacant = data.state.waiting = Eigen::VectorXd::Zero(3);
  data.points = Eigen::MatrixXd::Zero(3, 2);
  data.demand.mean = Eigen::VectorXd::Zero(6);
  data.transitions.assign(2, testing::simple_transitions());
  return data;
}

std::vector<Report> no_reports() {
  std::vector<Report> reports(3);
  for (int i = 0; i < 3; ++i) {
    reports[static_cast<std::size_t>(i)].region = i;
  }
  return reports;
}

TEST(FreedCars, HasAsManySlotsAsAreLeft) {
  const DayClock clock;
  EXPECT_EQ(slots_at(clock, 0, {}), 9);
  EXPECT_EQ(slots_at(clock, clock.minutes() - 60, {}), 6);
  EXPECT_EQ(slots_at(clock, clock.minutes() - 50, {}), 5);
  EXPECT_EQ(slots_at(clock, clock.minutes() - 5, {}), 1);
}

TEST(FreedCars, CountsCarsFromTheSlotInWhichTheyArrive) {
  auto reports = no_reports();
  reports[1].bound = {{1, now, Errand::rebalance, 1},       {1, now + 10, Errand::rebalance, 2},
                      {1, now + 11, Errand::rebalance, 4},  {1, now + 12, Errand::charge, 8},
                      {1, now + 60, Errand::passenger, 10}, {1, now + 61, Errand::rebalance, 16}};
  const FreedCars seen = freed_cars(quiet_data(), reports, now, 6, sessions, {}, {});
  const Eigen::RowVectorXd expected = (Eigen::RowVectorXd(6) << 3, 7, 7, 7, 7, 16).finished();
  EXPECT_TRUE(seen.mean.row(1).isApprox(expected)) << seen.mean.row(1);
  EXPECT_EQ(seen.mean.row(0).sum() + seen.mean.row(2).sum(), 0.0);
  EXPECT_NEAR(seen.variance(1, 5), 10 * 0.9 * 0.1, 1e-12);
  EXPECT_EQ(seen.variance(1, 4), 0.0);
}

// Sessions last 20 to 60 minutes, evenly.
TEST(FreedCars, CountsSessionsThatEnd) {
  auto reports = no_reports();
  reports[0].plugged_since = {now - 70, now - 40, now};
  const FreedCars seen = freed_cars(quiet_data(), reports, now, 6, sessions, {}, {});
  EXPECT_DOUBLE_EQ(seen.mean(0, 0), 1.0 + 0.5) << "overdue, and one of 40 minutes";
  EXPECT_DOUBLE_EQ(seen.mean(0, 3), 1.0 + 1.0 + 0.5);
  EXPECT_DOUBLE_EQ(seen.variance(0, 3), 0.25);
  EXPECT_DOUBLE_EQ(seen.mean(0, 5), 3.0);
}

// 12 passengers an hour from region 0 to region 2, 20 minutes away.
TEST(FreedCars, CountsPassengersToComeWhereTheyGetOut) {
  PlanningData data = quiet_data();
  data.state.vacant << 100.0, 0.0, 0.0;
  data.state.waiting << 2.5, 0.0, 0.0;
  data.demand.mean << 6.0, 0.0, 0.0, 6.0, 0.0, 0.0;
  const std::vector<TripShare> trips{{0, 1, 0.25}, {0, 2, 0.75}, {1, 1, 1.0}, {2, 2, 1.0}};
  const FreedCars seen = freed_cars(data, no_reports(), now, 6, sessions, trips, {});
  const double served = 0.95 * 0.9;
  EXPECT_EQ(seen.mean(2, 1), 0.0) << "2 minutes until they are met and 20 on the way";
  EXPECT_NEAR(seen.mean(2, 2), served * 0.75 * (2.0 + 8.0 * 0.2), 1e-12);
  EXPECT_NEAR(seen.mean(2, 5), served * 0.75 * (2.0 + 38.0 * 0.2), 1e-12);
  EXPECT_NEAR(seen.mean(1, 1), served * 0.25 * (2.0 + 8.0 * 0.2), 1e-12);
  EXPECT_NEAR(seen.variance(2, 5), seen.mean(2, 5), 1e-12);
}

// Who is served at the end of the slots sits in a car, or has got out of one that is counted again.
RC_GTEST_PROP(FreedCars, AddsUpToTheFleet, ()) {
  PlanningData data = quiet_data();
  for (auto& move : data.transitions) {
    move.vacant_to_low_battery.setZero();
  }
  auto reports = no_reports();
  double fleet = 0.0;
  for (int i = 0; i < 3; ++i) {
    Report& report = reports[static_cast<std::size_t>(i)];
    report.vacant = *rc::gen::inRange(0, 5);
    data.state.vacant(i) = report.vacant;
    report.plugged_since.assign(static_cast<std::size_t>(*rc::gen::inRange(0, 3)), now - *rc::gen::inRange(0, 90));
    report.bound = {{i, now + *rc::gen::inRange(0, 60), *rc::gen::element(Errand::passenger, Errand::rebalance),
                     *rc::gen::inRange(1, 4)}};
    fleet += report.vacant + static_cast<double>(report.plugged_since.size()) + report.bound.front().count;
  }
  const std::vector<TripShare> trips = testing::small_model().trips.front().shares;
  const FreedCars quiet = freed_cars(data, reports, now, 6, sessions, trips, {});
  RC_ASSERT(std::abs(data.state.vacant.sum() + quiet.mean.col(5).sum() - fleet) < 1e-9);

  data.demand.mean.setConstant(*rc::gen::inRange(1, 30));
  const FreedCars busy = freed_cars(data, reports, now, 6, sessions, trips, {});
  const double wanted = data.demand.mean.sum();
  const double again = busy.mean.col(5).sum() - quiet.mean.col(5).sum();
  BalancingParameters all;
  all.flow_served = 1.0;
  data.state.vacant.setConstant(1e6);
  const FreedCars served = freed_cars(data, reports, now, 6, sessions, trips, all);
  const double share = again / (served.mean.col(5).sum() - quiet.mean.col(5).sum());
  RC_ASSERT(share <= 0.95 + 1e-9);
  RC_ASSERT(share * wanted <= fleet + again + 1e-6);
  for (int k = 1; k < 6; ++k) {
    RC_ASSERT((busy.mean.col(k) - busy.mean.col(k - 1)).minCoeff() >= -1e-12);
  }
}

}  // namespace
}  // namespace evbal

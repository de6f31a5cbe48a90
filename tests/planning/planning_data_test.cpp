#include "coordinator/planning/planning_data.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

TEST(HorizonAt, ShortensAtTheDaysEnd) {
  const DayClock clock;
  EXPECT_EQ(horizon_at(clock, 0, 2), 2);
  EXPECT_EQ(horizon_at(clock, clock.minutes() - 60, 2), 2);
  EXPECT_EQ(horizon_at(clock, clock.minutes() - 30, 2), 1);
  EXPECT_EQ(horizon_at(clock, clock.minutes() - 10, 2), 1);
  EXPECT_EQ(horizon_at(clock, clock.minutes() - 70, 4), 3);
}

TEST(FleetState, CountsCarsWhereAndWhenTheyArrive) {
  std::vector<Report> reports(2);
  reports[1].region = 1;
  reports[0].vacant = 3;
  reports[0].chargeable = 1;
  reports[1].low_battery = 2;
  reports[1].reach_m = {1250};
  reports[1].plugged = 4;
  reports[1].points = 5;
  reports[0].waiting = 6;
  reports[0].bound = {{0, 100, Errand::passenger, 1}, {0, 129, Errand::rebalance, 2}, {0, 130, Errand::rebalance, 3},
                      {0, 130, Errand::charge, 1},    {0, 150, Errand::passenger, 7}, {0, 160, Errand::rebalance, 9}};
  const FleetState state = fleet_state(reports, 100, 30, 2);
  EXPECT_EQ(state.vacant(0), 3.0);
  EXPECT_EQ(state.low_battery(1), 2.0);
  EXPECT_EQ(state.chargeable(0), 1.0);
  EXPECT_EQ(state.reach.at(1), (std::vector<double>{1.25}));
  EXPECT_EQ(state.plugged(1), 4.0);
  EXPECT_EQ(state.waiting(0), 6.0);
  EXPECT_EQ(state.occupied(0), 8.0);
  EXPECT_EQ(state.dropoffs_due(0, 0), 1.0);
  EXPECT_EQ(state.dropoffs_due(0, 1), 7.0);
  EXPECT_DOUBLE_EQ(state.arriving_vacant(0, 0), 2.0 / 30.0) << "a minute of the step is left";
  EXPECT_DOUBLE_EQ(state.arriving_vacant(0, 1), 2.0 * 29.0 / 30.0 + 3.0);
  EXPECT_EQ(state.arriving_low_battery(0, 1), 1.0);
  EXPECT_DOUBLE_EQ(state.arriving_vacant.sum(), 5.0) << "each once; what arrives after the horizon is left out";
  EXPECT_EQ(points_ahead(reports, 2)(1, 1), 5.0);
}

// Sessions last 20 to 60 minutes, evenly.
TEST(FreePoints, CountsWhatFinishesGivenItsAge) {
  std::vector<Report> reports(2);
  reports[1].region = 1;
  reports[0].points = 5;
  reports[0].plugged = 3;
  reports[0].plugged_since = {30, 60, 100};
  MomentSet completions;
  completions.mean = Eigen::VectorXd::Zero(4);
  completions.deviation = Eigen::VectorXd::Ones(4);
  completions.factors = Eigen::MatrixXd::Ones(4, 1);
  completions.g1 = 0.3;
  const MomentSet set = free_points(reports, 100, 30, {20.0, 40.0, 60.0}, completions);
  // since 30: overdue; since 60: 40 minutes old, all of its kind end within 20; since 100: new, a quarter within 30.
  EXPECT_DOUBLE_EQ(set.mean(0), 2.0 + 1.0 + 1.0 + 0.25);
  EXPECT_DOUBLE_EQ(set.deviation(0), std::sqrt(0.25 * 0.75));
  EXPECT_DOUBLE_EQ(set.mean(2), 5.0) << "after an hour all are free";
  EXPECT_DOUBLE_EQ(set.mean(1), 0.0);
  EXPECT_DOUBLE_EQ(set.deviation(1), 0.1);
  EXPECT_EQ(set.factors.cols(), 0);
  EXPECT_EQ(set.g1, 0.3);
}

}  // namespace
}  // namespace evbal

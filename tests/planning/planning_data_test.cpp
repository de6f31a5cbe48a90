#include "coordinator/planning/planning_data.hpp"

#include <gtest/gtest.h>

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
  reports[1].low_battery = 2;
  reports[1].plugged = 4;
  reports[1].points = 5;
  reports[0].waiting = 6;
  reports[0].bound = {{0, 100, Errand::passenger, 1}, {0, 129, Errand::rebalance, 2}, {0, 130, Errand::rebalance, 3},
                      {0, 130, Errand::charge, 1},    {0, 150, Errand::passenger, 7}, {0, 160, Errand::rebalance, 9}};
  const FleetState state = fleet_state(reports, 100, 30, 2);
  EXPECT_EQ(state.vacant(0), 3.0);
  EXPECT_EQ(state.low_battery(1), 2.0);
  EXPECT_EQ(state.plugged(1), 4.0);
  EXPECT_EQ(state.waiting(0), 6.0);
  EXPECT_EQ(state.occupied(0), 8.0);
  EXPECT_EQ(state.arriving_vacant(0, 0), 2.0);
  EXPECT_EQ(state.arriving_vacant(0, 1), 3.0);
  EXPECT_EQ(state.arriving_low_battery(0, 1), 1.0);
  EXPECT_EQ(state.arriving_vacant.sum(), 5.0) << "what arrives after the horizon is left out";
  EXPECT_EQ(points_ahead(reports, 2)(1, 1), 5.0);
}

}  // namespace
}  // namespace evbal

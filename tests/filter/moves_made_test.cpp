#include "coordinator/filter/moves_made.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// Three regions, ten minutes from each to the next, four within each.
Eigen::MatrixXd minutes() {
  return (Eigen::MatrixXd(3, 3) << 4, 12, 15, 12, 4, 6, 15, 6, 4).finished();
}

PlanMade plan(std::vector<Move> moves) {
  PlanMade made{0,
                std::move(moves),
                {{}, {}, {}},
                Eigen::VectorXd::Constant(3, 5.0),
                Eigen::VectorXd::Constant(3, 2.0),
                {false, false, false}};
  made.bound[0] = {{0, 3, Errand::passenger, 2}, {0, 14, Errand::passenger, 1}};
  made.bound[2] = {{2, 8, Errand::charge, 1}};
  return made;
}

TEST(MovesMade, CountsWhatArrivesAndWhatSetsOff) {
  const PlanMade last = plan({{0, 1, 3, Errand::rebalance},
                              {1, 2, 2, Errand::rebalance},
                              {1, 0, 1, Errand::charge},
                              {2, 2, 1, Errand::charge}});
  const std::vector<std::vector<UnderWay>> now = {{{0, 12, Errand::charge, 1}, {0, 14, Errand::passenger, 1}},
                                                  {{1, 12, Errand::rebalance, 3}},
                                                  {{2, 20, Errand::passenger, 4}}};
  const RoadTraffic traffic = traffic_since(last, now, 10, minutes());
  EXPECT_EQ(traffic.came_vacant, Eigen::Vector3d(2, 0, 2)) << "two passengers' cars, and two that needed six minutes";
  EXPECT_EQ(traffic.came_low, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(traffic.left_vacant, Eigen::Vector3d(3, 2, 0));
  EXPECT_EQ(traffic.left_low, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(traffic.topped_up, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(traffic.may_stay, Eigen::Vector3i(0, 0, 0));
}

TEST(MovesMade, MissesCarsWhereTheyWereOnlyEstimated) {
  PlanMade last = plan({{0, 1, 3, Errand::rebalance}, {2, 0, 4, Errand::rebalance}});
  last.bound = {{}, {}, {}};
  const std::vector<std::vector<UnderWay>> now = {{{0, 15, Errand::rebalance, 1}}, {{1, 12, Errand::rebalance, 2}}, {}};
  const RoadTraffic reported = traffic_since(last, now, 10, minutes());
  EXPECT_EQ(reported.left_vacant, Eigen::Vector3d(3, 0, 4));
  EXPECT_EQ(reported.may_stay, Eigen::Vector3i(1, 0, 3));
  last.estimated = {false, false, true};
  const RoadTraffic estimated = traffic_since(last, now, 10, minutes());
  EXPECT_EQ(estimated.left_vacant, Eigen::Vector3d(3, 0, 1));
  EXPECT_EQ(estimated.may_stay, Eigen::Vector3i(1, 0, 0));
}

TEST(MovesMade, SeesCarsWaitOnTheRoadBeforeAnAbsentRegion) {
  PlanMade last = plan({});
  const RoadTraffic traffic = traffic_since(last, last.bound, 10, minutes());
  EXPECT_EQ(traffic.came_vacant, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(traffic.came_low, Eigen::Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace evbal

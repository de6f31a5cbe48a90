#include "coordinator/balancing/dropoffs.hpp"

#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(Dropoffs, ServeAgainWithinTheStep) {
  auto data = random_planning_data(1, {.regions = 2, .tau = 1});
  data.demand.mean << 10.0, 0.0;
  data.state.waiting << 5.0, 0.0;
  data.state.dropoffs_due << 0.0, 2.0;
  data.turnover.same_step_dropoffs << 0.0, 0.5, 0.0, 0.0;
  const auto demand = demand_with_waiting(data);
  EXPECT_DOUBLE_EQ(demand(0, 0), 14.0);
  const Eigen::Vector2d vacant(8.0, 1.0);
  const auto A = dropoffs(data, demand, vacant);
  EXPECT_DOUBLE_EQ(A(0, 0), 0.0);
  EXPECT_DOUBLE_EQ(A(1, 0), 2.0 + 0.5 * 8.0);
  data.transitions[0].vacant_to_low_battery << 0.0, 0.0, 0.1, 0.15;
  EXPECT_DOUBLE_EQ(serving_again(data, A)(1, 0), 0.6 * 0.75 * 6.0);
}

TEST(Dropoffs, OfOnesAreCountedAgain) {
  auto data = random_planning_data(1, {.regions = 1, .tau = 1});
  data.demand.mean << 100.0;
  data.state.waiting << 0.0;
  data.state.dropoffs_due << 0.0;
  data.turnover.same_step_dropoffs << 0.5;
  const auto A = dropoffs(data, demand_with_waiting(data), Eigen::VectorXd::Constant(1, 10.0));
  EXPECT_GT(A(0, 0), 8.0) << "5, and 2 of those 5, ...";
  EXPECT_LT(A(0, 0), 5.0 / (1.0 - 0.4)) << "the limit";
}

}  // namespace
}  // namespace evbal

#include "coordinator/balancing/top_up.hpp"

#include "coordinator/balancing/controllers.hpp"
#include "tests/balancing/solving_controllers.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

/// One region with ten vacant cars and three points, one of them in use.
PlanningData ten_vacant_cars(double demand, int tau = 1) {
  auto data = random_planning_data(3, {.regions = 1, .tau = tau, .rank = 0, .station_share = 1.0});
  data.state.vacant << 10.0;
  data.state.chargeable << 4.0;
  data.state.low_battery << 0.0;
  data.state.plugged << 1.0;
  data.state.waiting << 0.0;
  data.state.arriving_vacant.setZero();
  data.state.arriving_low_battery.setZero();
  data.state.dropoffs_due.setZero();
  data.freed.mean.setZero();
  data.freed.variance.setZero();
  data.points.setConstant(3.0);
  data.demand.mean.setConstant(demand);
  data.demand.deviation.setConstant(0.1);
  data.demand_samples = data.demand.mean;
  data.completions.mean.setZero();
  return data;
}

double topped_up(const std::string& controller, const PlanningData& data, const BalancingParameters& parameters = {}) {
  const auto result = balance(controller, parameters, data, {.name = "cuts"});
  EXPECT_TRUE(result.certificate.optimal()) << controller << ": " << result.certificate.reason;
  double cars = 0.0;
  for (const Flow& flow : result.dispatch.top_up) {
    EXPECT_EQ(flow.from, flow.to);
    cars += flow.amount;
  }
  return cars;
}

TEST(TopUp, HasRoomWherePointsStayFree) {
  auto data = ten_vacant_cars(2.0, 2);
  EXPECT_EQ(top_up_room(data)(0), 2.0);
  data.state.arriving_low_battery << 0.0, 1.0;
  EXPECT_EQ(top_up_room(data)(0), 1.0) << "one is on its way to a point";
  data.state.low_battery << 4.0;
  EXPECT_EQ(top_up_room(data)(0), 0.0);
  data.points.setConstant(30.0);
  EXPECT_EQ(top_up_room(data)(0), 4.0) << "the others are full";
}

// What it is worth is less than a passenger, and more than a car to spare.
TEST(TopUp, IsForCarsToSpare) {
  BalancingParameters parameters;
  parameters.eta = 0.0;
  for (const auto& controller : controller_names()) {
    const double expected = controller == "none" ? 0.0 : 2.0;
    EXPECT_NEAR(topped_up(controller, ten_vacant_cars(2.0), parameters), expected, 1e-6) << controller;
    EXPECT_NEAR(topped_up(controller, ten_vacant_cars(20.0), parameters), 0.0, 1e-6) << controller;
  }
}

TEST(TopUp, CostsWhatStaysUnused) {
  for (const auto& controller : solving_controllers()) {
    BalancingParameters parameters;
    parameters.top_up = 0.0;
    const auto result = balance(controller, parameters, ten_vacant_cars(2.0), {.name = "cuts"});
    const auto term = std::ranges::find(result.cost, "top-up", &CostTerm::name);
    ASSERT_NE(term, result.cost.end());
    EXPECT_EQ(term->cost, 0.0);
  }
}

// After the mean session, in steps, it is there again: at 25 minutes in the second step, at 45 not within two.
TEST(TopUp, IsAwayForTheMeanSession) {
  const auto rises = [](double minutes) {
    auto data = ten_vacant_cars(20.0, 2);
    data.demand.mean(0) = 2.0;
    data.demand_samples = data.demand.mean;
    data.transitions[0].vacant_to_vacant << 1.0;
    data.transitions[0].vacant_to_occupied << 0.0;
    data.transitions[0].vacant_to_low_battery << 0.0;
    data.state.occupied << 0.0;
    data.mean_session_minutes = minutes;
    return topped_up("ratio", data);
  };
  EXPECT_NEAR(rises(25.0), 2.0, 1e-6);
  EXPECT_NEAR(rises(45.0), 0.0, 1e-6);
}

TEST(TopUp, IsRoundedWithinWhatIsLeft) {
  auto data = ten_vacant_cars(2.0);
  const auto cars = [&](double amount, const std::vector<VehicleFlow>& sent) {
    int sum = 0;
    for (const auto& flow : whole_top_ups({{0, 0, amount}}, data, sent)) {
      sum += flow.vehicles;
    }
    return sum;
  };
  EXPECT_EQ(cars(1.5, {}), 2);
  EXPECT_EQ(cars(1.4, {}), 1);
  EXPECT_EQ(cars(0.4, {}), 0);
  EXPECT_EQ(cars(7.0, {}), 2);
  EXPECT_EQ(cars(2.0, {{0, 1, 9}}), 1);
  EXPECT_EQ(cars(2.0, {{0, 1, 10}}), 0);
}

}  // namespace
}  // namespace evbal

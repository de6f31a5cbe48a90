#include "coordinator/balancing/send_limits.hpp"

#include "coordinator/balancing/heuristics.hpp"
#include "coordinator/balancing/round_to_vehicles.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace evbal {
namespace {

FleetState five_low_battery_cars(std::vector<double> reach) {
  FleetState state;
  state.low_battery = Eigen::VectorXd::Constant(1, 5.0);
  state.reach = {std::move(reach)};
  return state;
}

TEST(ReachLimits, CountTheCarsThatGetSoFar) {
  const FleetState state = five_low_battery_cars({1.0, 4.0});
  EXPECT_EQ(low_battery_reaching(state, 0, 0.5), 5.0);
  EXPECT_EQ(low_battery_reaching(state, 0, 1.0), 5.0);
  EXPECT_EQ(low_battery_reaching(state, 0, 1.1), 4.0);
  EXPECT_EQ(low_battery_reaching(state, 0, 9.0), 3.0);
}

TEST(ReachLimits, SayEachThingOnce) {
  const std::vector<Arc> arcs = {{0, 1, 0.5}, {0, 2, 6.0}, {0, 3, 2.0}, {0, 4, 3.0}, {0, 5, 8.0}};
  const auto limits = reach_limits(five_low_battery_cars({1.0, 4.0}), arcs);
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_EQ(limits[0].targets, (std::vector<int>{5, 2}));
  EXPECT_EQ(limits[0].most, 3.0);
  EXPECT_EQ(limits[1].targets, (std::vector<int>{5, 2, 4, 3}));
  EXPECT_EQ(limits[1].most, 4.0);
  EXPECT_TRUE(reach_limits(five_low_battery_cars({}), arcs).empty());
}

/// Random reach of the low-battery cars that there are.
PlanningData with_random_reach() {
  auto data = random_planning_data(*rc::gen::arbitrary<std::uint64_t>(),
                                   {.regions = *rc::gen::inRange(2, 9), .tau = 1, .station_share = 0.7});
  data.state.low_battery *= 8.0;
  for (Eigen::Index i = 0; i < data.km.rows(); ++i) {
    auto& reach = data.state.reach[static_cast<std::size_t>(i)];
    reach.resize(static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(data.state.low_battery(i)) + 1)));
    for (double& km : reach) {
      km = *rc::gen::inRange(0, 100) / 10.0;
    }
    std::ranges::sort(reach);
  }
  return data;
}

/// Whether each car can be given one of the ways: the farthest way to the car that gets farthest.
bool can_be_driven(const PlanningData& data, int from, std::vector<double> ways) {
  auto cars = data.state.reach[static_cast<std::size_t>(from)];
  cars.resize(static_cast<std::size_t>(data.state.low_battery(from)), HUGE_VAL);
  std::ranges::sort(ways, std::ranges::greater{});
  std::ranges::reverse(cars);
  return ways.size() <= cars.size() &&
         std::ranges::equal(ways, std::span(cars).first(ways.size()), std::ranges::less_equal{});
}

RC_GTEST_PROP(ReachLimits, LeaveWholeVehiclesThatGetThere, ()) {
  const auto data = with_random_reach();
  const int n = static_cast<int>(data.km.rows());
  std::vector<Flow> flows;
  std::vector<Arc> arcs;
  for (int from = 0; from < n; ++from) {
    for (int to = 0; to < n; ++to) {
      if (from != to) {
        flows.push_back({from, to, *rc::gen::inRange(0, 60) / 10.0});
        arcs.push_back({from, to, data.km(from, to)});
      }
    }
  }
  const auto whole = round_to_vehicles(flows, data.state.low_battery.cast<int>(), reach_limits(data.state, arcs));
  for (int from = 0; from < n; ++from) {
    std::vector<double> ways;
    for (const auto& flow : whole) {
      ways.insert(ways.end(), flow.from == from ? static_cast<std::size_t>(flow.vehicles) : 0,
                  data.km(flow.from, flow.to));
    }
    RC_ASSERT(can_be_driven(data, from, ways));
  }
}

RC_GTEST_PROP(ReachLimits, AreKeptByRules, ()) {
  const auto data = with_random_reach();
  for (const auto& dispatch : {plan_none(data), plan_greedy({}, data)}) {
    for (int from = 0; from < data.km.rows(); ++from) {
      std::vector<double> ways;
      for (const auto& flow : dispatch.low_battery.front()) {
        ways.insert(ways.end(), flow.from == from ? static_cast<std::size_t>(flow.amount) : 0, data.km(from, flow.to));
      }
      RC_ASSERT(can_be_driven(data, from, ways));
    }
  }
}

}  // namespace
}  // namespace evbal

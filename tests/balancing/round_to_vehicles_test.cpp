#include "coordinator/balancing/round_to_vehicles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace evbal {
namespace {

std::vector<int> counts(const std::vector<double>& amounts, int available) {
  std::vector<Flow> flows;
  for (std::size_t i = 0; i < amounts.size(); ++i) {
    flows.push_back({0, static_cast<int>(i) + 1, amounts[i]});
  }
  std::vector<int> result(amounts.size());
  for (const auto& [from, to, vehicles] :
       round_to_vehicles(flows, Eigen::VectorXi::Constant(flows.size() + 1, available))) {
    EXPECT_EQ(from, 0);
    EXPECT_GE(vehicles, 1);
    result[static_cast<std::size_t>(to) - 1] = vehicles;
  }
  return result;
}

TEST(RoundToVehicles, LargestRemaindersComeFirst) {
  EXPECT_EQ(counts({1.4, 0.7, 2.0, 0.5}, 10), (std::vector{1, 1, 2, 1}));  // 4.6 is 5
  EXPECT_EQ(counts({0.4, 0.4, 0.4}, 10), (std::vector{1, 0, 0}));          // ties by index
  EXPECT_EQ(counts({0.2, 0.2}, 10), (std::vector{0, 0}));
}

TEST(RoundToVehicles, NoiseOfASolverDoesNotDecide) {
  EXPECT_EQ(counts({0.5 - 1e-9, 0.5 + 1e-9}, 10), (std::vector{1, 0}));
  EXPECT_EQ(counts({2.9999999, 1e-8}, 3), (std::vector{3, 0}));
}

TEST(RoundToVehicles, TooMuchIsCutInProportion) {
  EXPECT_EQ(counts({4.0, 8.0}, 3), (std::vector{1, 2}));
  EXPECT_EQ(counts({4.0, 8.0}, 0), (std::vector{0, 0}));
}

std::vector<std::array<int, 3>> sent(const std::vector<Flow>& flows, int available) {
  std::vector<std::array<int, 3>> result;
  for (const auto& [from, to, vehicles] : round_to_vehicles(flows, Eigen::VectorXi::Constant(3, available))) {
    result.push_back({from, to, vehicles});
  }
  return result;
}

TEST(RoundToVehicles, TakesFlowsInAnyOrder) {
  const std::vector<std::array<int, 3>> expected = {{0, 1, 1}, {0, 2, 2}, {1, 0, 2}};
  EXPECT_EQ(sent({{0, 1, 1.0}, {0, 2, 2.0}, {1, 0, 2.0}}, 3), expected);
  EXPECT_EQ(sent({{0, 2, 2.0}, {1, 0, 2.0}, {0, 1, 1.0}}, 3), expected);
  EXPECT_EQ(sent({{0, 1, 3.0}, {1, 0, 1.0}, {0, 2, 3.0}}, 3),
            (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 1}, {1, 0, 1}}))
      << "no region sends more than it has";
  EXPECT_EQ(sent({{0, 1, 0.6}, {0, 2, 1.0}, {0, 1, 0.6}}, 3), (std::vector<std::array<int, 3>>{{0, 1, 1}, {0, 2, 1}}));
}

TEST(RoundToVehiclesDeathTest, RefusesFlowsThatAreNone) {
  const auto send = [](const Flow& flow, int available) { round_to_vehicles({flow}, Eigen::Vector2i(available, 5)); };
  EXPECT_DEATH(send({0, 0, 1.0}, 5), "flows between two regions");
  EXPECT_DEATH(send({0, 2, 1.0}, 5), "flows between two regions");
  EXPECT_DEATH(send({-1, 1, 1.0}, 5), "flows between two regions");
  for (const double amount : {-0.1, 1e13, std::nan("")}) {
    EXPECT_DEATH(send({0, 1, amount}, 5), "amounts within");
  }
  EXPECT_DEATH(send({0, 1, 1.0}, -1), "less than no vehicles");
}

RC_GTEST_PROP(RoundToVehicles, KeepsTheCapAndStaysWithinOneVehicle, ()) {
  const auto millis = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 20'000));
  const int available = *rc::gen::inRange(0, 100);
  std::vector<double> amounts;
  double sum = 0.0;
  for (const int m : millis) {
    amounts.push_back(m / 1000.0);
    sum += m / 1000.0;
  }
  const auto whole = counts(amounts, available);
  int total = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    total += whole[i];
    RC_ASSERT(whole[i] <= std::ceil(amounts[i]));
    RC_ASSERT(sum > available || whole[i] >= std::floor(amounts[i]));
  }
  RC_ASSERT(total <= available);
  RC_ASSERT(std::abs(total - std::min<double>(sum, available)) <= 0.5 + 1e-9);
}

}  // namespace
}  // namespace evbal

#include "coordinator/balancing/heuristics.hpp"

#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

// Three regions 2 km (4 min) apart in a row, a station with one free point in the first and in the last.
PlanningData row_of_three() {
  PlanningData data = random_planning_data(1, {.regions = 3, .tau = 1});
  data.km << 0.5, 2.0, 4.0, 2.0, 0.5, 2.1, 4.0, 2.1, 0.5;
  data.minutes = 2.0 * data.km;
  data.state.vacant.setZero();
  data.state.low_battery.setZero();
  data.state.plugged.setZero();
  data.state.waiting.setZero();
  data.state.arriving_vacant.setZero();
  data.state.arriving_low_battery.setZero();
  data.points << 1.0, 0.0, 1.0;
  data.demand.mean.setZero();
  data.mean_session_minutes = 45.0;
  return data;
}

double amount(const std::vector<Flow>& flows, int from, int to) {
  double sum = 0.0;
  for (const auto& flow : flows) {
    sum += flow.from == from && flow.to == to ? flow.amount : 0.0;
  }
  return sum;
}

TEST(None, SendsOnlyLowBatteryCarsToTheNearestStation) {
  auto data = row_of_three();
  data.state.vacant << 9.0, 0.0, 0.0;
  data.demand.mean << 0.0, 9.0, 9.0;
  data.state.low_battery << 2.0, 3.0, 0.0;
  const auto dispatch = plan_none(data);
  EXPECT_TRUE(dispatch.vacant.front().empty());
  ASSERT_EQ(dispatch.low_battery.front().size(), 1U);
  EXPECT_EQ(amount(dispatch.low_battery.front(), 1, 0), 3.0);
}

TEST(Greedy, ServesTheNearestShortageWithWhatCanBeSpared) {
  auto data = row_of_three();
  data.state.vacant << 12.0, 0.0, 0.0;
  data.demand.mean << 2.0, 3.0, 9.0;
  data.state.waiting << 0.0, 1.0, 0.0;
  data.state.arriving_vacant << 0.0, 1.0, 3.0;
  const auto flows = plan_greedy({}, data).vacant.front();
  EXPECT_EQ(amount(flows, 0, 1), 3.0);
  EXPECT_EQ(amount(flows, 0, 2), 6.0);
}

TEST(Greedy, SharesWhatIsNotEnough) {
  auto data = row_of_three();
  data.state.vacant << 9.0, 0.0, 0.0;
  data.demand.mean << 6.0, 6.0, 6.0;
  const auto flows = plan_greedy({}, data).vacant.front();
  EXPECT_EQ(amount(flows, 0, 1), 3.0);
  EXPECT_EQ(amount(flows, 0, 2), 3.0);
}

TEST(Greedy, WeighsTravelAgainstTheQueue) {
  auto data = row_of_three();
  data.state.low_battery << 0.0, 2.0, 0.0;
  auto flows = plan_greedy({}, data).low_battery.front();
  EXPECT_EQ(amount(flows, 1, 0), 1.0);  // one each: the second would wait a session behind the first
  EXPECT_EQ(amount(flows, 1, 2), 1.0);
  data.state.plugged << 1.0, 0.0, 0.0;
  data.state.low_battery << 1.0, 0.0, 0.0;
  flows = plan_greedy({}, data).low_battery.front();
  EXPECT_EQ(amount(flows, 0, 2), 1.0);  // leaves a queue for a free point
  data.points << 0.0, 0.0, 0.0;
  EXPECT_TRUE(plan_greedy({}, data).low_battery.front().empty());
}

RC_GTEST_PROP(Heuristics, NeverSendMoreThanThereIs, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const int regions = *rc::gen::inRange(1, 12);
  const auto data = random_planning_data(seed, {.regions = regions});
  for (const auto& dispatch : {plan_none(data), plan_greedy({}, data)}) {
    Eigen::VectorXd vacant = data.state.vacant;
    for (const auto& flow : dispatch.vacant.front()) {
      vacant(flow.from) -= flow.amount;
    }
    Eigen::VectorXd low = data.state.low_battery;
    for (const auto& flow : dispatch.low_battery.front()) {
      low(flow.from) -= flow.amount;
      RC_ASSERT(data.points(flow.to, 0) > 0.0);
    }
    RC_ASSERT(vacant.minCoeff() >= 0.0);
    RC_ASSERT(low.minCoeff() >= 0.0);
  }
}

}  // namespace
}  // namespace evbal

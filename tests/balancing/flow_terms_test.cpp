#include "coordinator/balancing/flow_terms.hpp"

#include "coordinator/balancing/controllers.hpp"
#include "coordinator/balancing/cumulative_demand.hpp"
#include "coordinator/balancing/discrete_distribution.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

namespace evbal {
namespace {

// What a passenger costs who goes without a car in one slot of K: all slots cost p_flow, the last one half of it alone.
double price(int k, int K) {
  return BalancingParameters{}.p_flow * (k + 1 == K ? 0.5 + 0.5 / K : 0.5 / K);
}

// A city without passengers, cars and chargers, in which all ways are of 5 km and 15 minutes.
PlanningData empty_city(int regions) {
  PlanningData data = random_planning_data(1, {.regions = regions, .rank = 0, .station_share = 0.0});
  data.km.setConstant(5.0);
  data.minutes.setConstant(15.0);
  for (auto* vector :
       {&data.state.vacant, &data.state.occupied, &data.state.low_battery, &data.state.plugged, &data.state.waiting}) {
    vector->setZero();
  }
  data.state.arriving_vacant.setZero();
  data.state.arriving_low_battery.setZero();
  data.state.dropoffs_due.setZero();
  data.demand.mean.setZero();
  data.freed.mean.setZero();
  data.freed.variance.setZero();
  data.worth = {};
  return data;
}

double cost_of(const std::string& term, const BalancingResult& result) {
  const auto found = std::ranges::find(result.cost, term, &CostTerm::name);
  return found == result.cost.end() ? 0.0 : found->cost;
}

BalancingResult flow(const PlanningData& data, const BalancingParameters& parameters = {},
                     Uncertainty demand = Uncertainty::counts) {
  const auto plan = optimum({Shortage::flow, demand, Uncertainty::mean});
  const BalancingResult result = balance({.name = "flow", .plan = plan}, parameters, data, {.name = "cuts"});
  EXPECT_TRUE(result.certificate.optimal()) << result.certificate.reason;
  return result;
}

TEST(CumulativeDemand, GrowsEvenlyWithinSteps) {
  PlanningData data = empty_city(2);
  data.state.waiting << 5.0, 0.0;
  data.demand.mean << 6.0, 0.0, 12.0, 3.0;  // two steps of 30 minutes
  const CumulativeDemand demand(data);
  EXPECT_DOUBLE_EQ(demand.within(0.0, 0), 4.0);
  EXPECT_DOUBLE_EQ(demand.within(10.0, 0), 4.0 + 2.0);
  EXPECT_DOUBLE_EQ(demand.within(45.0, 0), 4.0 + 6.0 + 6.0);
  EXPECT_DOUBLE_EQ(demand.within(45.0, 1), 1.5);
  EXPECT_DOUBLE_EQ(demand.within(90.0, 1), 6.0) << "as in the last step";
}

TEST(Flow, SendsTheCarThatArrivesInTime) {
  PlanningData data = empty_city(3);
  data.state.vacant << 1.0, 1.0, 0.0;
  data.state.waiting << 0.0, 0.0, 1.25;
  data.km(0, 2) = 3.0;
  data.minutes(0, 2) = 45.0;
  data.minutes(1, 2) = 9.0;
  const BalancingResult result = flow(data, {}, Uncertainty::mean);
  ASSERT_EQ(result.dispatch.vacant.front().size(), 1U);
  EXPECT_EQ(result.dispatch.vacant.front()[0].from, 1) << "5 km and 9 minutes, not 3 km and 45 minutes";
  EXPECT_EQ(result.dispatch.vacant.front()[0].to, 2);
  EXPECT_NEAR(result.dispatch.vacant.front()[0].amount, 1.0, 1e-6);
  data.state.vacant(1) = 0.0;
  data.minutes(0, 2) = 61.0;
  EXPECT_TRUE(flow(data).dispatch.vacant.front().empty()) << "after the last slot";
}

TEST(Flow, CountsACarOnce) {
  PlanningData data = empty_city(3);
  data.state.vacant << 1.0, 0.0, 0.0;
  data.state.waiting << 0.0, 1.25, 1.25;
  const BalancingResult one = flow(data, {}, Uncertainty::mean);
  ASSERT_EQ(one.dispatch.vacant.front().size(), 1U);
  EXPECT_NEAR(cost_of("shortage", one), BalancingParameters{}.p_flow + price(0, 6), 1e-6)
      << "a passenger waits, one for a slot of six";
  // A car on its way to one of them is none the less one car, and none is sent after it.
  data.state.vacant.setZero();
  data.freed.mean.row(1).tail(5).setOnes();
  data.state.waiting(2) = 0.0;
  const BalancingResult under_way = flow(data, {}, Uncertainty::mean);
  EXPECT_TRUE(under_way.dispatch.vacant.front().empty());
  EXPECT_NEAR(cost_of("shortage", under_way), price(0, 6), 1e-6);
}

// Cars that become vacant are sent in the slot after, at the earliest.
TEST(Flow, SendsNobodyWhoIsNotThereYet) {
  PlanningData data = empty_city(2);
  data.freed.mean.row(0).setOnes();
  data.state.waiting << 0.0, 1.25;
  const BalancingResult result = flow(data, {}, Uncertainty::mean);
  EXPECT_TRUE(result.dispatch.vacant.front().empty());
  EXPECT_NEAR(cost_of("km", result), 5.0, 1e-6) << "it is sent in slot 1";
  EXPECT_NEAR(cost_of("shortage", result), 2.0 * price(0, 6), 1e-6) << "and there by the end of slot 2";
}

TEST(Flow, PricesTheExpectedShortageOfItsDistribution) {
  for (const double vacant : {0.0, 1.0, 4.5, 11.0, 60.0}) {
    PlanningData data = empty_city(1);
    data.state.vacant << vacant;
    data.state.waiting << 3.0;
    data.demand.mean << 9.0, 5.0;
    data.freed.mean.row(0) << 0.1, 0.5, 0.5, 1.0, 3.0, 3.25;
    data.freed.variance = 0.5 * data.freed.mean;
    double expected = 0.0;
    for (int k = 0; k < 6; ++k) {
      const double minutes = 10.0 * (k + 1) - BalancingParameters{}.flow_patience;
      const double mean = 2.4 + 9.0 / 30.0 * std::min(minutes, 30.0) + 5.0 / 30.0 * std::max(0.0, minutes - 30.0);
      const double variance = data.turnover.demand.at(k / 3, mean) + data.freed.variance(0, k);
      const DiscreteDistribution law = negative_binomial(mean, variance, 1.0 / 16.0);
      for (std::size_t m = 0; m < law.values.size(); ++m) {
        expected += price(k, 6) * law.probabilities[m] * std::max(0.0, law.values[m] - vacant - data.freed.mean(0, k));
      }
    }
    EXPECT_NEAR(cost_of("shortage", flow(data)), expected, 1e-6) << vacant << " vacant";
  }
}

// No passenger is in sight; a car in region 1 will be worth more than one in region 0, by more than the way or by less.
TEST(Flow, SendsCarsWhereTheyWillBeWorthMore) {
  PlanningData data = empty_city(2);
  data.state.vacant << 2.0, 0.0;
  data.worth = {Eigen::Vector2d(10.0, 20.0), Eigen::Vector2d::Zero()};
  const BalancingResult sent = flow(data);
  ASSERT_EQ(sent.dispatch.vacant.front().size(), 1U);
  EXPECT_NEAR(sent.dispatch.vacant.front()[0].amount, 2.0, 1e-6) << "6 km gained with 5";
  EXPECT_NEAR(cost_of("worth", sent), 0.0, 1e-6);
  data.worth.vacant(1) = 18.0;
  const BalancingResult stayed = flow(data);
  EXPECT_TRUE(stayed.dispatch.vacant.front().empty()) << "4.8 km are not";
  EXPECT_NEAR(cost_of("worth", stayed), 2.0 * 4.8, 1e-6);
  data.worth.vacant(1) = 100.0;
  BalancingParameters blind;
  blind.flow_value = 0.0;
  EXPECT_TRUE(flow(data, blind).dispatch.vacant.front().empty());
}

// What is known of the time after the slots stands in for the price of having no car at their end.
TEST(Flow, PricesTheEndOfItsSlotsByWhatIsNotKnownOfTheTimeAfterThem) {
  PlanningData data = empty_city(1);
  data.state.waiting << 1.25;
  data.worth = {Eigen::VectorXd::Constant(1, 7.0), Eigen::VectorXd::Constant(1, 7.0)};
  const BalancingParameters half{.flow_value = 0.5};
  const BalancingParameters all{.flow_value = 1.0};
  const auto shortage = [](const BalancingResult& result) { return cost_of("shortage", result); };
  EXPECT_NEAR(shortage(flow(data, half, Uncertainty::mean)), half.p_flow, 1e-6)
      << "all shares of it, whatever they are";
  data.freed.mean.row(0).tail(1).setOnes();
  EXPECT_NEAR(shortage(flow(data, half, Uncertainty::mean)), 0.75 * half.p_flow * 5.0 / 6.0, 1e-6);
  EXPECT_NEAR(shortage(flow(data, all, Uncertainty::mean)), all.p_flow * 5.0 / 6.0, 1e-6);
  data.worth = {};
  EXPECT_NEAR(shortage(flow(data, all, Uncertainty::mean)), 0.5 * all.p_flow * 5.0 / 6.0, 1e-6) << "nothing is known";
}

// One car, a passenger in each of two regions: the one whose way leads to where cars are worth more is taken.
TEST(Flow, TakesThePassengerAfterWhomTheCarIsWorthMore) {
  PlanningData data = empty_city(3);
  data.state.vacant << 1.0, 0.0, 0.0;
  data.state.waiting << 0.0, 1.25, 1.25;
  data.worth = {Eigen::Vector3d::Constant(10.0), Eigen::Vector3d(0.0, 5.0, 8.0)};
  const BalancingResult result = flow(data, {}, Uncertainty::mean);
  ASSERT_EQ(result.dispatch.vacant.front().size(), 1U);
  EXPECT_EQ(result.dispatch.vacant.front()[0].to, 2);
  std::swap(data.worth.serving(1), data.worth.serving(2));
  EXPECT_EQ(flow(data, {}, Uncertainty::mean).dispatch.vacant.front()[0].to, 1);
  const BalancingParameters cheap{.p_flow = 6.5};
  data.worth.serving = data.worth.vacant;
  EXPECT_FALSE(flow(data, cheap, Uncertainty::mean).dispatch.vacant.front().empty()) << "with the last slot worth 5 km";
  data.worth.vacant.setConstant(1e4);
  EXPECT_TRUE(flow(data, cheap, Uncertainty::mean).dispatch.vacant.front().empty()) << "no passenger is worth the car";
}

TEST(Flow, StartsFromTheCurvesOfTheLastPlanAlone) {
  PlanningData data = random_planning_data(2, {.regions = 5});
  const BalancingResult first = flow(data);
  EXPECT_FALSE(first.start.has_basis());
  EXPECT_FALSE(first.start.empty());
  data.start = first.start;
  const BalancingResult again = flow(data);
  EXPECT_LT(again.certificate.iterations, first.certificate.iterations);
  data.start = balance("nominal", {}, data, {.name = "cuts"}).start;
  EXPECT_TRUE(data.start.has_basis());
  EXPECT_NEAR(flow(data).certificate.objective, first.certificate.objective, 1e-6 * first.certificate.objective);
}

// A car: where it becomes vacant, and by the end of which slot; -1 is now.
struct Car {
  int region;
  int slot;
};

// The least cost over all ways to send whole cars, each at most once, in slots 0 and 1 of three; N[i][k] passengers.
double least_cost(const PlanningData& data, const std::vector<Car>& cars,
                  const std::function<double(int i, int k, double C)>& shortage) {
  const int n = static_cast<int>(data.km.rows());
  constexpr int K = 3;
  double least = 1e9;
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(n, K);
  const std::function<void(std::size_t, double)> place = [&](std::size_t car, double km) {
    if (car == cars.size()) {
      double cost = km;
      for (int i = 0; i < n; ++i) {
        for (int k = 0; k < K; ++k) {
          cost += shortage(i, k, C(i, k));
        }
      }
      least = std::min(least, cost);
      return;
    }
    const auto [from, since] = cars[car];
    const auto add = [&](int region, int first, int end, double count) {
      C.row(region).segment(std::min(first, K), std::max(0, end - std::min(first, K))).array() += count;
    };
    add(from, std::max(0, since), K, 1.0);
    place(car + 1, km);
    for (int m = since + 1; m < 2; ++m) {
      for (int to = 0; to < n; ++to) {
        const int arrives = m + static_cast<int>(std::ceil(data.minutes(from, to) / 10.0)) - 1;
        if (to != from && arrives < K) {
          add(from, m, K, -1.0);
          add(to, arrives, K, 1.0);
          place(car + 1, km + data.km(from, to));
          add(to, arrives, K, -1.0);
          add(from, m, K, 1.0);
        }
      }
    }
    add(from, std::max(0, since), K, -1.0);
  };
  place(0, 0.0);
  return least;
}

// No car is sent on within the slots, since ways take more than ten minutes.
TEST(Flow, AgreesWithBruteForceOverWholeCars) {
  BalancingParameters parameters;
  parameters.flow_sends = 2;
  parameters.flow_patience = 10.0;  // passengers are whole at the ends of slots
  const std::vector<Car> cars{{0, -1}, {0, -1}, {1, -1}, {1, 0}, {2, 0}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    PlanningData data = empty_city(3);
    const PlanningData random = random_planning_data(seed, {.regions = 3});
    data.km = random.km;
    data.minutes = (4.0 * random.minutes).cwiseMax(11.0);
    data.state.vacant << 2.0, 1.0, 0.0;
    data.freed.mean = Eigen::MatrixXd::Zero(3, 3);
    data.freed.mean.row(1).setOnes();
    data.freed.mean.row(2).setOnes();
    data.freed.variance = Eigen::MatrixXd::Zero(3, 3);
    data.demand.mean = 3.0 * (random.demand.mean / 8.0).array().floor();  // whole passengers a slot
    const CumulativeDemand demand(data);
    const auto sure = [&](int i, int k, double C) {
      return price(k, 3) * std::max(0.0, demand.within(10.0 * (k + 1) - parameters.flow_patience, i) - C);
    };
    const auto result = flow(data, parameters, Uncertainty::mean);
    EXPECT_NEAR(cost_of("km", result) + cost_of("shortage", result), least_cost(data, cars, sure), 1e-5) << seed;

    const auto expected = [&](int i, int k, double C) {
      const double mean = demand.within(10.0 * (k + 1) - parameters.flow_patience, i);
      const auto law = negative_binomial(mean, data.turnover.demand.at(0, mean), 1.0 / 16.0);
      double missing = 0.0;
      for (std::size_t m = 0; m < law.values.size(); ++m) {
        missing += law.probabilities[m] * std::max(0.0, law.values[m] - C);
      }
      return price(k, 3) * missing;
    };
    const auto random_demand = flow(data, parameters);
    const double whole = least_cost(data, cars, expected);
    const double parts = cost_of("km", random_demand) + cost_of("shortage", random_demand);
    EXPECT_LE(parts, whole + 1e-5) << "parts of cars can do all that whole ones can";
    EXPECT_GE(parts, 0.98 * whole) << "and hardly more";
  }
}

RC_GTEST_PROP(Flow, KeepsTheFleet, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto data = random_planning_data(seed, {.regions = *rc::gen::inRange(1, 7)});
  BalancingParameters parameters;
  const Formulation formulation = formulate(parameters, data, {Shortage::flow, Uncertainty::counts, Uncertainty::mean});
  const Solution solution = solve(formulation.program, {.name = "cuts"});
  RC_ASSERT(solution.certificate.optimal());
  const int last = static_cast<int>(data.freed.mean.cols()) - 1;
  double cars = 0.0;  // by the end of the last slot, when all have arrived
  for (const auto& block : formulation.program.blocks()) {
    if (block.name.what == "cars" && block.name.step == last) {
      cars += solution.x.segment(block.first, block.size).sum();
    }
  }
  RC_ASSERT(std::abs(cars - data.state.vacant.sum() - data.freed.mean.col(last).sum()) < 1e-5);
  Eigen::VectorXd left = data.state.vacant;
  const Dispatch dispatch = dispatch_at(formulation, solution.x);
  for (const auto& [from, to, amount] : dispatch.vacant.front()) {
    left(from) -= amount;
  }
  RC_ASSERT(left.minCoeff() >= -1e-6);
}

}  // namespace
}  // namespace evbal

// Cars under way without passengers count once, from the step in which they arrive.

#include "coordinator/balancing/controllers.hpp"
#include "coordinator/balancing/formulation.hpp"
#include "coordinator/balancing/heuristics.hpp"
#include "coordinator/balancing/uncertainty_model.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace evbal {
namespace {

/// Nobody is served, runs low or ends a session, and no point is free: cars are where they are sent, and stay.
PlanningData standstill(int tau) {
  auto data = random_planning_data(*rc::gen::arbitrary<std::uint64_t>(),
                                   {.regions = *rc::gen::inRange(1, 7), .tau = tau, .vehicles_per_region = 30.0});
  for (auto& move : data.transitions) {
    move.vacant_to_vacant.setIdentity();
    move.vacant_to_occupied.setZero();
    move.vacant_to_low_battery.setZero();
    move.occupied_to_vacant.setZero();
    move.occupied_to_occupied.setIdentity();
  }
  data.points.setOnes();
  data.state.plugged.setOnes();
  data.completions.mean.setZero();
  return data;
}

double sum_of(const Formulation& formulation, const Eigen::VectorXd& x, const std::string& what, int step) {
  double sum = 0.0;
  for (const auto& block : formulation.program.blocks()) {
    sum += block.name.what == what && block.name.step == step ? x.segment(block.first, block.size).sum() : 0.0;
  }
  return sum;
}

RC_GTEST_PROP(Arrivals, CountOnceFromTheirOwnStepOn, ()) {
  const auto data = standstill(3);
  const auto options =
      *rc::gen::element(FormulationOptions{Shortage::band, Uncertainty::worst_case, Uncertainty::mean},
                        FormulationOptions{Shortage::turnover, Uncertainty::counts, Uncertainty::mean});
  const auto formulation = formulate({}, data, options);
  const auto solution = solve(formulation.program, {.name = "cuts"});
  RC_ASSERT(solution.certificate.optimal());
  const Eigen::MatrixXd undisturbed = vacant_without_dispatch(data, Eigen::MatrixXd::Zero(data.km.rows(), 3));
  double vacant = data.state.vacant.sum();
  double low_battery = data.state.low_battery.sum();
  for (int k = 0; k < 3; ++k) {
    vacant += data.state.arriving_vacant.col(k).sum();
    low_battery += data.state.arriving_low_battery.col(k).sum();
    RC_ASSERT(std::abs(sum_of(formulation, solution.x, "S", k) - vacant) < 1e-5);
    RC_ASSERT(std::abs(sum_of(formulation, solution.x, "Y", k) - low_battery) < 1e-5);
    RC_ASSERT(std::abs(undisturbed.col(k).sum() - vacant) < 1e-9);
  }
}

/// Two regions; passengers wait in the second, to which enough cars are under way.
PlanningData relief_under_way() {
  auto data = random_planning_data(1, {.regions = 2, .tau = 1, .rank = 0, .station_share = 0.0});
  data.km << 0.5, 3.0, 3.0, 0.5;
  data.state.vacant << 8.0, 0.0;
  data.state.low_battery.setZero();
  data.state.waiting.setZero();
  data.state.dropoffs_due.setZero();
  data.state.arriving_vacant << 0.0, 8.0;
  data.freed.mean.setZero();
  data.freed.mean.row(1).setConstant(8.0);
  data.freed.variance.setZero();
  data.demand.mean << 4.0, 4.0;
  data.demand.deviation.setConstant(0.1);
  return data;
}

TEST(Arrivals, NeedNoSecondCar) {
  for (const auto& controller : controller_names()) {
    auto data = relief_under_way();
    data.demand_samples = data.demand.mean;
    const auto before = balance(controller, {}, data, {.name = "cuts"}).dispatch.vacant.front();
    EXPECT_TRUE(before.empty()) << controller << " sends " << before.front().amount;
    data.state.arriving_vacant.setZero();
    data.freed.mean.setZero();
    EXPECT_EQ(balance(controller, {}, data, {.name = "cuts"}).dispatch.vacant.front().empty(), controller == "none")
        << controller;
  }
}

}  // namespace
}  // namespace evbal

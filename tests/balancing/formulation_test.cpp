#include "coordinator/balancing/formulation.hpp"

#include "coordinator/convex/engine.hpp"
#include "tests/balancing/plain_formulation.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace evbal {
namespace {

double optimum_of(const ConvexProgram& program, const std::string& engine) {
  const auto certificate = solve(program, {.name = engine}).certificate;
  RC_ASSERT(certificate.optimal());
  return certificate.objective;
}

PlanningData any_data() {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const int regions = *rc::gen::inRange(1, 8);
  auto data = random_planning_data(
      seed, {.regions = regions, .tau = *rc::gen::inRange(1, 5), .chargeable_share = *rc::gen::element(0.0, 0.6)});
  data.mean_session_minutes = *rc::gen::element(25.0, 45.0, 100.0);
  for (int i = 0; i < regions; ++i) {  // of some low-battery cars, how far they get
    const int known = *rc::gen::inRange(0, static_cast<int>(data.state.low_battery(i)) + 1);
    for (int car = 0; car < known; ++car) {
      data.state.reach[static_cast<std::size_t>(i)].push_back(1.5 * car);
    }
  }
  if (*rc::gen::arbitrary<bool>()) {  // an outage under plugged cars, in one step
    data.points.col(*rc::gen::inRange<Eigen::Index>(0, data.points.cols())).setZero();
  }
  if (*rc::gen::arbitrary<bool>()) {
    data.state.low_battery(*rc::gen::inRange<Eigen::Index>(0, data.points.rows())) = 0.0;
    data.state.vacant(*rc::gen::inRange<Eigen::Index>(0, data.points.rows())) = 0.0;
  }
  return data;
}

FormulationOptions any_band() {
  return *rc::gen::element(FormulationOptions{Shortage::band, Uncertainty::mean, Uncertainty::mean},
                           FormulationOptions{Shortage::band, Uncertainty::worst_case, Uncertainty::mean},
                           FormulationOptions{Shortage::band, Uncertainty::samples, Uncertainty::mean},
                           FormulationOptions{Shortage::turnover, Uncertainty::counts, Uncertainty::mean});
}

// Linear programs without J_E, which both formulations solve exactly.
RC_GTEST_PROP(Formulation, HasTheOptimumOfTheProblemWithEveryVariable, ()) {
  const auto data = any_data();
  const auto options = any_band();
  BalancingParameters parameters;
  parameters.theta_0 = 0.0;
  const double plain = optimum_of(PlainFormulation(parameters, data, options).program, "cuts");
  const double reduced = optimum_of(formulate(parameters, data, options).program, "cuts");
  RC_ASSERT(std::abs(reduced - plain) <= 1e-7 * std::max(1.0, std::abs(plain)));
}

RC_GTEST_PROP(Formulation, HasTheOptimumOfTheProblemWithEveryVariableByAnyEngine, ()) {
  const auto data = any_data();
  const auto options = any_band();
  const double plain = optimum_of(PlainFormulation({}, data, options).program, *rc::gen::elementOf(engine_names()));
  const double reduced = optimum_of(formulate({}, data, options).program, *rc::gen::elementOf(engine_names()));
  RC_ASSERT(std::abs(reduced - plain) <= 2e-6 * std::max(1.0, std::abs(plain)));
}

TEST(Formulation, HasTheRowsThatItsHeaderNames) {
  const std::set<std::string> named = {"supply", "sent",     "low-battery", "sent to charge", "plugged in",
                                       "points", "released", "O",           "shortage",       "within reach"};
  auto data = random_planning_data(1, {.regions = 9, .tau = 3});
  data.state.low_battery.setConstant(3.0);
  data.state.reach.assign(9, {0.0});
  const auto program = formulate({}, data, {}).program;
  std::set<std::string> found;
  for (int row = 0; row < program.rows(); ++row) {
    found.insert(program.name_of_row(row).what);
  }
  EXPECT_EQ(found, named);
}

// Two regions, one with points: the rows of one step, by hand.
TEST(Formulation, HasNoVariableForWhatIsZero) {
  auto data = random_planning_data(1, {.regions = 2, .tau = 1, .station_share = 1.0});
  data.points << 5.0, 0.0;
  data.state.vacant << 3.0, 0.0;
  data.state.low_battery << 0.0, 2.0;
  data.state.plugged << 0.0, 0.0;
  const auto program = formulate({}, data, {}).program;
  std::multiset<std::string> variables;
  for (const auto& block : program.blocks()) {
    variables.insert(block.name.what + "*" + std::to_string(block.size));
  }
  EXPECT_EQ(variables,
            (std::multiset<std::string>{"S*2", "x*1", "y*1", "Y*1", "Z*1", "u*1", "shortage*3", "shortage*3"}));
  std::multiset<std::string> rows;
  for (int row = 0; row < program.rows(); ++row) {
    rows.insert(program.name_of_row(row).text());
  }
  EXPECT_EQ(rows,
            (std::multiset<std::string>{"supply[0], step 0", "supply[1], step 0", "sent[0], step 0",
                                        "low-battery[0], step 0", "sent to charge[1], step 0", "plugged in[0], step 0",
                                        "points[0], step 0", "shortage[0], step 0", "shortage[1], step 0"}));
}

}  // namespace
}  // namespace evbal

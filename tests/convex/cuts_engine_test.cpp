#include "coordinator/convex/cuts_engine.hpp"

#include "coordinator/balancing/controllers.hpp"
#include "coordinator/balancing/formulation.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

const FormulationOptions robust = {.demand = Uncertainty::worst_case, .supply = Uncertainty::worst_case};

Certificate certificate(const std::string& engine, const ConvexProgram& program) {
  return solve(program, {.name = engine}).certificate;
}

RC_GTEST_PROP(CutsEngine, AgreesWithIpopt, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto data = random_planning_data(
      seed, {.regions = *rc::gen::inRange(1, 7), .tau = *rc::gen::inRange(1, 4), .rank = *rc::gen::inRange(0, 3)});
  const auto program = formulate({}, data, robust).program;
  const auto cuts = certificate("cuts", program);
  const auto ipopt = certificate("ipopt", program);
  RC_ASSERT(cuts.optimal());
  RC_ASSERT(ipopt.optimal());
  const double scale = std::max(1.0, std::abs(ipopt.objective));
  RC_ASSERT(std::abs(cuts.objective - ipopt.objective) <= 1e-6 * scale);
  RC_ASSERT(cuts.lower_bound <= ipopt.objective + 1e-9 * scale);
  RC_ASSERT(ipopt.lower_bound <= cuts.objective + 1e-9 * scale);
}

// min (x + 1)^-1 + x / 4  is at x = 1.
TEST(CutsEngine, FindsAnOptimumBetweenTangents) {
  ConvexProgram program;
  const auto x = program.add_variable("x", 0.0, 10.0);
  const auto z = program.add_variable("z");
  program.at_least_curve(z, x, inverse_power(1.0, 1.0));
  program.minimise("cost", z + 0.25 * x);
  const auto solution = solve(program, {.name = "cuts"});
  ASSERT_TRUE(solution.certificate.optimal()) << solution.certificate.reason;
  EXPECT_NEAR(solution.certificate.objective, 0.75, 1e-6);
  EXPECT_LE(solution.certificate.lower_bound, 0.75);
  EXPECT_NEAR(solution.x(0), 1.0, 1e-2);
  EXPECT_EQ(solution.certificate.max_violation, 0.0);
}

// min || (x, 2 y) ||  with  x + y = 5:  x = 4, y = 1.
TEST(CutsEngine, FindsTheLeastNorm) {
  ConvexProgram program;
  const auto x = program.add_block("x", 2);
  program.add(x[0] + x[1] == 5.0);
  program.minimise_norm("norm", {3.0, {0, 1}, Eigen::Vector2d(1.0, 2.0), Eigen::MatrixXd(2, 0)});
  const auto solution = solve(program, {.name = "cuts"});
  ASSERT_TRUE(solution.certificate.optimal()) << solution.certificate.reason;
  EXPECT_NEAR(solution.certificate.objective, 3.0 * std::sqrt(20.0), 2e-5);
  EXPECT_NEAR(solution.x(0), 4.0, 0.05);
}

// r_hat / (S + 1/2) falls by thousands a vehicle where demand is high and cars are few.
TEST(CutsEngine, SettlesOnSteepCurves) {
  auto data = random_planning_data(60, {.regions = 21, .tau = 1, .rank = 0, .vehicles_per_region = 100.0});
  data.demand.mean *= 10.0;
  const auto certificate = balance("ratio", {}, data, {.name = "cuts"}).certificate;
  EXPECT_TRUE(certificate.optimal()) << certificate.reason;
  EXPECT_LT(certificate.iterations, 20);
}

PlanningData any_data(int regions, int tau) {
  return random_planning_data(*rc::gen::arbitrary<std::uint64_t>(), {.regions = regions, .tau = tau, .rank = 2});
}

RC_GTEST_PROP(CutsEngine, FindsTheOptimumFromThatOfAnotherProblem, ()) {
  const int regions = *rc::gen::inRange(1, 9);
  const int tau = *rc::gen::inRange(1, 4);
  const auto other = formulate({}, any_data(regions, tau), robust).program;
  const auto program = formulate({}, any_data(regions, *rc::gen::inRange(1, tau + 1)), robust).program;
  const double afresh = certificate("cuts", program).objective;
  const auto again = solve(program, {.name = "cuts"}, solve(other, {.name = "cuts"}).start).certificate;
  RC_ASSERT(again.optimal());
  RC_ASSERT(std::abs(again.objective - afresh) <= 2e-6 * std::max(1.0, std::abs(afresh)));
}

// A start that names what there is at random: no basis at all.
RC_GTEST_PROP(CutsEngine, FindsTheOptimumFromAnyStart, ()) {
  const auto program = formulate({}, any_data(4, 2), robust).program;
  const auto afresh = solve(program, {.name = "cuts"});
  Start start;
  for (int variable = 0; variable < program.variables(); ++variable) {
    auto& keys = *rc::gen::arbitrary<bool>() ? start.basic : start.at_upper;
    keys.push_back(key_of(program.name_of({variable})));
  }
  std::ranges::sort(start.basic);
  std::ranges::sort(start.at_upper);
  start.curves = afresh.start.curves;
  const auto again = solve(program, {.name = "cuts"}, start).certificate;
  RC_ASSERT(again.optimal());
  const double expected = afresh.certificate.objective;
  RC_ASSERT(std::abs(again.objective - expected) <= 2e-6 * std::max(1.0, std::abs(expected)));
}

TEST(CutsEngine, NeedsFewerLinearProgramsFromItsOwnOptimum) {
  const auto program = formulate({}, random_planning_data(1, {.regions = 20}), robust).program;
  const auto first = solve(program, {.name = "cuts"});
  EXPECT_FALSE(first.start.empty());
  const auto second = solve(program, {.name = "cuts"}, first.start);
  EXPECT_TRUE(second.certificate.optimal()) << second.certificate.reason;
  EXPECT_LT(second.certificate.iterations, first.certificate.iterations);
}

TEST(CutsEngine, SaysThatNoPointIsFeasible) {
  ConvexProgram program;
  const auto x = program.add_variable("x", 0.0, 1.0);
  program.add(2.0 <= x);
  const auto solution = solve(program, {.name = "cuts"});
  EXPECT_FALSE(solution.certificate.optimal());
  EXPECT_EQ(solution.x.size(), 0);
  EXPECT_EQ(solution.certificate.reason, "linear program 1: Clp finds no optimum");
}

TEST(CutsEngine, StopsWithItsBudgetAndSaysHowFarItGot) {
  const auto program = formulate({}, random_planning_data(1, {.regions = 8}), robust).program;
  const auto solution = solve(program, {.name = "cuts", .max_iterations = 1});
  EXPECT_FALSE(solution.certificate.optimal());
  EXPECT_EQ(solution.certificate.iterations, 1);
  EXPECT_TRUE(solution.certificate.reason.starts_with("the relative gap to the lower bound is 0.0"));
}

}  // namespace
}  // namespace evbal

#include "coordinator/convex/convex_program.hpp"

#include "coordinator/convex/certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

TEST(Program, RowsAreMergedAndSorted) {
  ConvexProgram program;
  const auto x = program.add_block("x", 3);
  program.add(2.0 * x[2] + x[0] + 1.0 == x[2] + x[1] - x[1]);
  ASSERT_EQ(program.rows(), 1);
  ASSERT_EQ(program.entries().size(), 2U);
  EXPECT_EQ(program.entries()[0].variable, 0);
  EXPECT_EQ(program.entries()[1].variable, 2);
  EXPECT_EQ(program.entries()[1].coefficient, 1.0);
  EXPECT_EQ(program.row_low()[0], -1.0);
  EXPECT_EQ(program.row_high()[0], -1.0);
}

TEST(Program, KeepsARowThatNoPointCanSatisfy) {
  ConvexProgram program;
  program.add_block("x", 1);
  program.add(Expression(1.0) <= 2.0);
  EXPECT_EQ(program.rows(), 0);
  program.add(Expression(2.0) <= 1.0);
  EXPECT_EQ(program.rows(), 1);
  EXPECT_DOUBLE_EQ(program.violation(Eigen::VectorXd::Zero(1)).amount, 1.0);
}

TEST(Program, ObjectiveAndViolationAreRecomputed) {
  ConvexProgram program;
  const auto x = program.add_block("x", 2);
  program.bound(x[0], 0.0, 4.0);
  program.minimise("cost", 3.0 * x[0] + 5.0);
  program.penalise(100.0 * x[1]);
  program.at_least_curve(x[1], x[0], inverse_power(1.0, 1.0));
  program.minimise_norm("norm", {2.0, {0, 1}, Eigen::Vector2d(3.0, 1.0), Eigen::Vector2d(0.0, 2.0)});
  const Eigen::Vector2d at(1.0, 0.25);
  EXPECT_DOUBLE_EQ(program.penalty(at), 25.0);
  EXPECT_DOUBLE_EQ(program.objective(at), 5.0 + 3.0 + 25.0 + 2.0 * std::sqrt(9.0 + 5.0 / 16.0));
  EXPECT_DOUBLE_EQ(program.violation(at).amount, 0.25);  // 1 / (1 + 1) - 0.25
  EXPECT_DOUBLE_EQ(program.violation(Eigen::Vector2d(-0.5, 4.0)).amount, 0.5);
  EXPECT_DOUBLE_EQ(program.violation(Eigen::Vector2d(5.5, 4.0)).amount, 1.5);
  EXPECT_EQ(program.violation(Eigen::Vector2d(std::nan(""), 1.0)).amount, ConvexProgram::infinity);
  EXPECT_EQ(program.violation(cleaned(program, at)).amount, 0.0);
}

TEST(Program, CertificateSaysWhatIsWrong) {
  ConvexProgram program;
  program.minimise("cost", program.add_variable("x", 1.0));
  const auto certificate = [&](double at, double lower_bound) {
    return certify(program, Eigen::VectorXd::Constant(1, at), lower_bound);
  };
  EXPECT_EQ(certificate(1.0, 1.0).status, SolveStatus::optimal);
  EXPECT_EQ(certificate(1.0, 1.0).reason, "");
  EXPECT_EQ(certificate(1.0, 0.9).status, SolveStatus::gap_open);
  EXPECT_EQ(certificate(1.0, 0.9).reason, "the relative gap to the lower bound is 0.1");
  EXPECT_EQ(certificate(0.9, 0.9).status, SolveStatus::infeasible);
  EXPECT_EQ(certificate(0.9, 0.9).reason, "lower bound of x: violated by 0.1");
  EXPECT_EQ(certificate(std::nan(""), 1.0).status, SolveStatus::infeasible);
  EXPECT_EQ(certificate(std::nan(""), 1.0).reason, "x: not a finite number");
  EXPECT_EQ(certificate(1.0, std::nan("")).status, SolveStatus::gap_open);
}

TEST(Program, NothingIsOptimalBelowItsLowerBound) {
  ConvexProgram program;
  program.minimise("cost", program.add_variable("x", 1.0));
  const auto certificate = certify(program, Eigen::VectorXd::Constant(1, 1.0), 1.1);
  EXPECT_EQ(certificate.status, SolveStatus::below_bound);
  EXPECT_EQ(certificate.reason, "the objective is below its lower bound: the relative gap is -0.1");
}

TEST(Program, AViolationNamesRowBoundOrCurve) {
  ConvexProgram program("vehicles");
  const auto S = program.add_block({"S", 1}, 2);
  const auto sent = program.add_variable({"x", 1, 0, 1}, 0.0, 8.0);
  const auto parts = program.add_block({"shortage", 1, 1}, 2);
  const auto Z = program.minimise_curve("utilisation", 1.0, S[0], inverse_power(1.0, 1.0), {"Z", 1, 0});
  program.add(S[1] == sent + 3.0, {"supply", 1, 1});
  const auto reason = [&](double S0, double S1, double x01, double part, double z) {
    Eigen::VectorXd at(program.variables());
    at << S0, S1, x01, 0.0, part, z;
    EXPECT_EQ(Z.index + 1, at.size());
    EXPECT_EQ(parts[1].index, 4);
    return certify(program, at, 0.0).reason;
  };
  EXPECT_EQ(reason(1.0, 4.6, 2.0, 0.0, 0.5), "supply[1], step 1: violated by 0.4 vehicles");
  EXPECT_EQ(reason(1.0, 12.0, 9.0, 0.0, 0.5), "upper bound of x[0,1], step 1: violated by 1 vehicles");
  EXPECT_EQ(reason(1.0, 4.0, 1.0, -0.5, 0.5), "lower bound of shortage[1,1], step 1: violated by 0.5 vehicles");
  EXPECT_EQ(reason(1.0, 4.0, 1.0, 0.0, 0.25), "curve of Z[0], step 1: violated by 0.25");
}

TEST(Program, CostByTermIsTheObjective) {
  ConvexProgram program;
  const auto x = program.add_block("x", 2);
  program.minimise("km", 3.0 * x[0]);
  program.minimise("queue", 2.0 * x[1] + 5.0);
  program.minimise("km", 4.0 * x[1] - 1.0);
  program.penalise(100.0 * x[1]);
  program.minimise_norm("queue", {2.0, {0, 1}, Eigen::Vector2d(3.0, 2.0), Eigen::MatrixXd(2, 0)});
  const auto costs = program.cost_by_term(Eigen::Vector2d(1.0, 2.0));
  ASSERT_EQ(costs.size(), 3U);
  EXPECT_EQ(costs[0].name, "km");
  EXPECT_DOUBLE_EQ(costs[0].cost, 3.0 + 8.0 - 1.0);
  EXPECT_EQ(costs[1].name, "queue");
  EXPECT_DOUBLE_EQ(costs[1].cost, 4.0 + 5.0 + 2.0 * 5.0);
  EXPECT_EQ(costs[2].name, "penalty");
  EXPECT_DOUBLE_EQ(costs[2].cost, 200.0);
}

TEST(Program, BoundsOnlyTighten) {
  ConvexProgram program;
  const auto x = program.add_block("x", 1, 0.0, 5.0);
  program.bound(x[0], -1.0, 3.0);
  program.bound(x[0], 1.0, 4.0);
  EXPECT_EQ(program.lower()[0], 1.0);
  EXPECT_EQ(program.upper()[0], 3.0);
}

TEST(Program, ACurveKeepsTheUpperBoundOfItsArgument) {
  ConvexProgram program;
  const auto x = program.add_block("x", 1, -1.0, 3.0);
  program.minimise_curve("cost", 1.0, x[0], inverse_power(1.0, 1.0), "z");
  EXPECT_EQ(program.lower()[0], 0.0);
  EXPECT_EQ(program.upper()[0], 3.0);
}

TEST(ProgramDeathTest, RefusesWhatNoProgramCanBe) {
  ConvexProgram program;
  const auto x = program.add_block("x", 2, 0.0, 5.0);
  EXPECT_DEATH(program.bound(x[0], 6.0, 7.0), "contract broken");
  EXPECT_DEATH(x[2], "an index within the block");
  EXPECT_DEATH(program.at_least_curve(x[1], x[0], inverse_power(1.0, 1.0)), "without an upper bound");
}

TEST(ConvexFunction, InversePowerHasItsDerivatives) {
  const auto f = inverse_power(1.0, 0.1);
  for (const double y : {0.0, 0.3, 7.0, 300.0}) {
    constexpr double h = 1e-5;
    const auto [value, slope, curvature] = f->around(y);
    EXPECT_NEAR(value, std::pow(y + 1.0, -0.1), 1e-15);
    EXPECT_NEAR(slope, (f->around(y + h).value - f->around(y - h).value) / (2 * h), 1e-9);
    EXPECT_NEAR(curvature, (f->around(y + h).slope - f->around(y - h).slope) / (2 * h), 1e-9);
    EXPECT_GT(curvature, 0.0);
  }
}

TEST(ConvexFunction, OfALineFollowsTheChainRule) {
  const auto f = of_line(inverse_power(1.0, 0.5), -2.0, 9.0);
  constexpr double h = 1e-5;
  const auto [value, slope, curvature] = f->around(3.0);
  EXPECT_DOUBLE_EQ(value, 0.5);
  EXPECT_NEAR(slope, (f->around(3.0 + h).value - f->around(3.0 - h).value) / (2 * h), 1e-9);
  EXPECT_NEAR(curvature, (f->around(3.0 + h).slope - f->around(3.0 - h).slope) / (2 * h), 1e-9);
}

}  // namespace
}  // namespace evbal

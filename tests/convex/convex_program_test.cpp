#include "coordinator/convex/convex_program.hpp"

#include "coordinator/convex/certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

TEST(Program, RowsAreMergedAndSorted) {
  ConvexProgram program;
  const auto x = program.add_block("x", 3);
  program.equal(2.0 * Expression(x[2]) + x[0] + 1.0, Expression(x[2]) + x[1] - Expression(x[1]));
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
  program.at_most(1.0, 2.0);
  EXPECT_EQ(program.rows(), 0);
  program.at_most(2.0, 1.0);
  EXPECT_EQ(program.rows(), 1);
  EXPECT_DOUBLE_EQ(program.violation(Eigen::VectorXd::Zero(1)), 1.0);
}

TEST(Program, ObjectiveAndViolationAreRecomputed) {
  ConvexProgram program;
  const auto x = program.add_block("x", 2, 0.0, 4.0);
  program.minimise(3.0 * Expression(x[0]) + 5.0);
  program.penalise(100.0 * Expression(x[1]));
  program.at_least_curve(x[1], x[0], inverse_power(1.0, 1.0));
  program.minimise_norm({2.0, {0, 1}, Eigen::Vector2d(3.0, 1.0), Eigen::Vector2d(0.0, 2.0)});
  const Eigen::Vector2d at(1.0, 0.25);
  EXPECT_DOUBLE_EQ(program.penalty(at), 25.0);
  EXPECT_DOUBLE_EQ(program.objective(at), 5.0 + 3.0 + 25.0 + 2.0 * std::sqrt(9.0 + 5.0 / 16.0));
  EXPECT_DOUBLE_EQ(program.violation(at), 0.25);  // 1 / (1 + 1) - 0.25
  EXPECT_DOUBLE_EQ(program.violation(Eigen::Vector2d(-0.5, 4.0)), 0.5);
  EXPECT_DOUBLE_EQ(program.violation(Eigen::Vector2d(5.5, 4.0)), 1.5);
  EXPECT_EQ(program.violation(Eigen::Vector2d(std::nan(""), 1.0)), ConvexProgram::infinity);
  EXPECT_EQ(program.violation(cleaned(program, at)), 0.0);
}

TEST(Program, CertificateSaysWhatIsWrong) {
  ConvexProgram program;
  const auto x = program.add_block("x", 1, 1.0);
  program.minimise(x[0]);
  EXPECT_TRUE(certify(program, Eigen::VectorXd::Constant(1, 1.0), 1.0).optimal);
  EXPECT_NE(certify(program, Eigen::VectorXd::Constant(1, 1.0), 0.9).why_not.find("gap"), std::string::npos);
  EXPECT_NE(certify(program, Eigen::VectorXd::Constant(1, 0.9), 0.9).why_not.find("violated"), std::string::npos);
  EXPECT_FALSE(certify(program, Eigen::VectorXd::Constant(1, std::nan("")), 1.0).optimal);
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

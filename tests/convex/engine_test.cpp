#include "coordinator/convex/engine.hpp"

#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace evbal {
namespace {

class EachEngine : public ::testing::TestWithParam<std::string> {
 protected:
  Solution solved(const ConvexProgram& program) const { return solve(program, {.name = GetParam()}); }

  std::string why_not(const ConvexProgram& program) const {
    const auto solution = solved(program);
    EXPECT_FALSE(solution.certificate.optimal());
    EXPECT_EQ(solution.x.size(), 0);
    return solution.certificate.reason;
  }
};

INSTANTIATE_TEST_SUITE_P(Engine, EachEngine, ::testing::ValuesIn(engine_names()));

// A curve of the test's own.
class Curve final : public ConvexFunction {
 public:
  explicit Curve(std::function<Expansion(double)> around) : around_(std::move(around)) {}

  Expansion around(double at) const override { return around_(at); }

 private:
  std::function<Expansion(double)> around_;
};

ConvexFunction::Expansion parabola(double at) {
  return {.value = (at - 2.0) * (at - 2.0), .slope = 2.0 * (at - 2.0), .curvature = 2.0};
}

// min z  over  z >= curve(x),  x within [0, 3].
ConvexProgram least_of(std::function<ConvexFunction::Expansion(double)> curve) {
  ConvexProgram program;
  const auto x = program.add_variable("x", 0.0, 3.0);
  const auto z = program.add_variable("z");
  program.at_least_curve(z, x, std::make_shared<Curve>(std::move(curve)));
  program.minimise("cost", z);
  return program;
}

// min price x  over  coefficient x >= side.
ConvexProgram linear(double price, double coefficient, double side, double constant = 0.0) {
  ConvexProgram program;
  const auto x = program.add_variable("x");
  program.add(coefficient * x >= side, "enough");
  program.minimise("cost", price * x + constant);
  return program;
}

TEST_P(EachEngine, RefusesNumbersThatNoSolverTakes) {
  for (const double wrong : {1e25, -1e25, 1e100, 1e300}) {
    EXPECT_TRUE(why_not(linear(wrong, 1.0, 1.0)).starts_with("cost of x")) << wrong;
    EXPECT_TRUE(why_not(linear(1.0, wrong, 1.0)).starts_with("coefficient of x")) << wrong;
    EXPECT_TRUE(why_not(linear(1.0, 1.0, 1.0, wrong)).starts_with("constant")) << wrong;
  }
  EXPECT_TRUE(why_not(linear(1.0, 1.0, 1e100)).starts_with("upper side of enough"));
  for (const double none : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(why_not(linear(none, 1.0, 1.0)), "");
    EXPECT_NE(why_not(linear(1.0, none, 1.0)), "");
    EXPECT_NE(why_not(linear(1.0, 1.0, 1.0, none)), "");
    EXPECT_NE(why_not(linear(1.0, 1.0, none)), "");
  }
}

TEST_P(EachEngine, TakesTheLargestNumbers) {
  for (const double large : {1e10, 1e19}) {
    EXPECT_NO_FATAL_FAILURE(solved(linear(large, 1.0, 1.0)));
    EXPECT_NO_FATAL_FAILURE(solved(linear(1.0, large, 1.0)));
    EXPECT_NO_FATAL_FAILURE(solved(linear(1.0, 1.0, large)));
  }
}

TEST_P(EachEngine, RefusesANormThatIsNoNumber) {
  for (const double wrong : {1e300, std::numeric_limits<double>::infinity()}) {
    for (const bool weight : {false, true}) {
      ConvexProgram program = linear(1.0, 1.0, 1.0);
      program.minimise_norm(
          "norm",
          {weight ? wrong : 1.0, {0}, Eigen::VectorXd::Constant(1, weight ? 1.0 : wrong), Eigen::MatrixXd(1, 0)});
      EXPECT_TRUE(why_not(program).starts_with("norm 0")) << wrong;
    }
  }
}

TEST_P(EachEngine, RefusesACurveThatIsInfinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_NE(why_not(least_of([&](double) { return ConvexFunction::Expansion{infinity, -infinity, infinity}; })), "");
  ConvexProgram program;
  program.minimise_curve("cost", 1.0, program.add_variable("x"), inverse_power(1e-200, 2.0), "z");
  EXPECT_TRUE(why_not(program).starts_with("curve of x"));
}

// Finite where the first tangents touch, and infinite where they meet.
TEST_P(EachEngine, RefusesAnObjectiveThatIsInfiniteAtItsFirstPoint) {
  const auto curve = [](double at) {
    ConvexFunction::Expansion expansion = parabola(at);
    expansion.value = at == 0.0 || at == 0.5 || at == 1.25 || at == 2.375 || at == 3.0
                          ? expansion.value
                          : std::numeric_limits<double>::infinity();
    return expansion;
  };
  EXPECT_NE(why_not(least_of(curve)), "");
}

TEST_P(EachEngine, LooksAtACurveWithinTheBoundsOfItsVariableAlone) {
  double least = 0.0;
  double most = 0.0;
  const auto solution = solved(least_of([&](double at) {
    least = std::min(least, at);
    most = std::max(most, at);
    return parabola(at);
  }));
  EXPECT_TRUE(solution.certificate.optimal()) << solution.certificate.reason;
  EXPECT_NEAR(solution.x(0), 2.0, 1e-2);
  EXPECT_GE(least, 0.0);
  EXPECT_LE(most, 3.0);
}

TEST_P(EachEngine, SolvesAProgramWithNothingToDecide) {
  ConvexProgram nothing;
  nothing.minimise("cost", 5.0);
  ConvexProgram fixed;
  const auto x = fixed.add_block("x", 2, 3.0, 3.0);
  fixed.minimise("cost", x[0] + x[1]);
  for (const auto& [program, objective] : {std::pair(nothing, 5.0), std::pair(fixed, 6.0)}) {
    const auto solution = solved(program);
    EXPECT_TRUE(solution.certificate.optimal()) << objective << ": " << solution.certificate.reason;
    EXPECT_NEAR(solution.certificate.objective, objective, 1e-8);
    EXPECT_EQ(solution.x.size(), program.variables());
  }
}

TEST_P(EachEngine, SaysThatItsBudgetWasNone) {
  const auto certificate = solve(linear(1.0, 1.0, 1.0), {.name = GetParam(), .max_iterations = 0}).certificate;
  EXPECT_EQ(certificate.status, SolveStatus::iteration_limit);
  EXPECT_NE(certificate.reason, "");
}

TEST(IpoptDeathTest, RefusesASolveWithinASolve) {
  const auto curve = [](double at) {
    solve(linear(1.0, 1.0, 1.0), {.name = "ipopt"});
    return parabola(at);
  };
  EXPECT_DEATH(solve(least_of(curve), {.name = "ipopt"}), "one solve by Ipopt at a time");
}

TEST(Ipopt, BringsNoMpiAlong) {
  ASSERT_TRUE(solve(least_of(parabola), {.name = "ipopt"}).certificate.optimal());
  const auto loaded = text_of("/proc/self/maps");
  EXPECT_NE(loaded.find("/libdmumps"), std::string::npos);
  EXPECT_EQ(loaded.find("/libmpi"), std::string::npos);
}

TEST(Cuts, SolvesInSeveralThreads) {
  const auto objective = [] { return solve(least_of(parabola), {.name = "cuts"}).certificate.objective; };
  const double alone = objective();
  std::vector<std::future<double>> beside;
  for (int thread = 0; thread < 4; ++thread) {
    beside.push_back(std::async(std::launch::async, objective));
  }
  for (auto& result : beside) {
    EXPECT_EQ(result.get(), alone);
  }
}

}  // namespace
}  // namespace evbal

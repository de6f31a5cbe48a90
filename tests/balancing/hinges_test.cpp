#include "coordinator/balancing/hinges.hpp"

#include "coordinator/convex/engine.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace evbal {
namespace {

// Halves, so that bends fall together now and then.
double halves(int low, int high) {
  return 0.5 * *rc::gen::inRange(low, high);
}

RC_GTEST_PROP(Hinges, EachTermCostsWhatItsHingesSay, ()) {
  ConvexProgram program;
  const double at = halves(0, 20);
  const Variable s = program.add_variable("s", at, at);
  std::vector<Hinge> hinges;
  std::map<std::string, double> expected;
  for (int left = *rc::gen::inRange(0, 9); left > 0; --left) {
    const bool falls = *rc::gen::arbitrary<bool>();
    hinges.push_back({falls ? "shortage" : "surplus", halves(1, 9) * (falls ? -1.0 : 1.0), halves(-6, 20)});
    expected[hinges.back().term] += std::max(0.0, hinges.back().slope * (at - hinges.back().bend));
  }
  minimise_hinges(program, s, hinges, "band");
  RC_ASSERT(program.rows() <= 1);
  const auto solution = solve(program, {.name = *rc::gen::elementOf(engine_names())});
  RC_ASSERT(solution.certificate.optimal());
  const auto costs = program.cost_by_term(solution.x);
  RC_ASSERT(costs.size() == expected.size());
  for (const CostTerm& term : costs) {
    RC_ASSERT(std::abs(term.cost - expected.at(term.name)) <= 1e-5 * std::max(1.0, expected.at(term.name)));
  }
}

TEST(Hinges, NeedNoRowWithoutABendAboveZero) {
  ConvexProgram program;
  const Variable s = program.add_variable("s");
  minimise_hinges(program, s, {{"shortage", -2.0, -1.0}, {"surplus", 3.0, 0.0}}, "band");
  EXPECT_EQ(program.rows(), 0);
  EXPECT_EQ(program.variables(), 1);
  EXPECT_EQ(program.cost()[0], 3.0);
}

}  // namespace
}  // namespace evbal

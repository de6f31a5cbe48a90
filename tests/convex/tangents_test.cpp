#include "coordinator/convex/tangents.hpp"

#include "coordinator/balancing/worst_case.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

double largest_tangent(const Tangents& tangents, double lower, double at) {
  double value = tangents.value_at_lower();
  double left = at - lower;
  for (const auto& piece : tangents.pieces()) {
    value += piece.slope * std::min(left, piece.width);
    left -= std::min(left, piece.width);
  }
  return value;
}

RC_GTEST_PROP(Tangents, LieBelowTheCurveAndTouchIt, (bool steep)) {
  const auto f = steep ? inverse_power(0.5, 1.0) : of_line(worst_case_shortage(2.0, 0.3, 1.5), 0.8, -6.0);
  const double lower = 0.01 * *rc::gen::inRange(0, 300);
  Tangents tangents(f, lower, ConvexProgram::infinity);
  for (const int hundredths : *rc::gen::resize(10, rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 50000)))) {
    const double at = lower + 0.01 * hundredths;
    tangents.add(at);
    tangents.add_around(f->around(at + 0.005).slope);
  }
  const auto pieces = tangents.pieces();
  for (std::size_t m = 0; m < pieces.size(); ++m) {
    RC_ASSERT(pieces[m].width >= 0.0);
    RC_ASSERT(pieces[m].slope >= pieces[m == 0 ? 0 : m - 1].slope);
    RC_ASSERT(std::abs(largest_tangent(tangents, lower, pieces[m].at) - f->around(pieces[m].at).value) < 1e-9);
  }
  for (int i = 0; i < 90; ++i) {
    const double at = lower + 0.5 * (std::pow(1.08, i) - 1.0);
    RC_ASSERT(largest_tangent(tangents, lower, at) <= f->around(at).value + 1e-9);
  }
}

TEST(Tangents, StayWithinTheEnds) {
  const auto f = inverse_power(1.0, 1.0);
  const Tangents few(f, 1.0, 3.0);
  EXPECT_EQ(few.pieces().front().at, 1.0);
  EXPECT_EQ(few.pieces().back().at, 3.0);
  const Tangents one(f, 2.0, 2.0);
  ASSERT_EQ(one.pieces().size(), 1U);
  EXPECT_EQ(one.value_at_lower(), f->around(2.0).value);
  Tangents two(f, 0.0, 1.0);
  EXPECT_DEATH(two.add(1.5), "a point between the ends");
}

// f(x) = (x + 1)^-1 has slope -1/9 at x = 2.
TEST(Tangents, GrowDenseWhereTheyAreAskedTo) {
  const auto f = inverse_power(1.0, 1.0);
  Tangents tangents(f, 0.0, ConvexProgram::infinity);
  const auto off = [&] { return f->around(2.0).value - largest_tangent(tangents, 0.0, 2.0); };
  const double before = off();
  EXPECT_GT(before, 1e-5);
  tangents.add_around(-1.0 / 9.0);
  EXPECT_LT(off(), before / 10.0);
  const auto tangents_before = tangents.pieces().size();
  tangents.add(2.0);
  tangents.add(2.0);
  EXPECT_EQ(tangents.pieces().size(), tangents_before + 1);
}

}  // namespace
}  // namespace evbal

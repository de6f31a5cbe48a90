#include "coordinator/balancing/worst_case.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

double psi(double d, double sigma, double g1, double g2) {
  return worst_case_shortage(d, sigma, g1, g2).value;
}

double number(int low, int high) {
  return 1e-3 * *rc::gen::inRange(1000 * low, 1000 * high);
}

TEST(WorstCaseShortage, AtPointsWorkedOutByHand) {
  EXPECT_DOUBLE_EQ(psi(0.0, 2.0, 0.25, 1.0), 1.5);  // v = 4, m = 1: (2 + 1) / 2
  EXPECT_DOUBLE_EQ(psi(0.0, 2.0, 0.0, 1.0), 1.0);   // Scarf's bound, sigma / 2
  EXPECT_DOUBLE_EQ(psi(4.0, 2.0, 1.0, 1.0), 0.25);  // only the second moment acts: v / (4 d)
  EXPECT_DOUBLE_EQ(psi(-3.0, 2.0, 9.0, 1.0), 5.0);  // all mass at m = 2
  EXPECT_DOUBLE_EQ(psi(-3.0, 2.0, 1.0, 0.0), 3.0);
}

// The bound is sharp: a distribution on two points that the set allows does as badly.
TEST(WorstCaseShortage, ADistributionOnTwoPointsAttainsIt) {
  const double v = 4.0;
  const double m = 1.0;
  const double d = 1.0;
  const double spread = std::sqrt(v - m * m + (d - m) * (d - m));
  const double high = d + spread;
  const double low = d - spread;
  const double share = (m - low) / (high - low);
  EXPECT_NEAR(share * high * high + (1.0 - share) * low * low, v, 1e-12);
  EXPECT_NEAR(share * (high - d), psi(d, 2.0, 0.25, 1.0), 1e-12);
}

RC_GTEST_PROP(WorstCaseShortage, HasItsDerivatives, ()) {
  const double sigma = number(1, 20);
  const double g1 = number(0, 3);
  const double g2 = 0.1 + number(0, 3);
  const double d = number(-50, 50);
  const double h = 1e-4 * sigma;
  const auto here = worst_case_shortage(d, sigma, g1, g2);
  const auto up = worst_case_shortage(d + h, sigma, g1, g2);
  const auto down = worst_case_shortage(d - h, sigma, g1, g2);
  RC_ASSERT(std::abs(here.slope - (up.value - down.value) / (2.0 * h)) < 1e-3);
  RC_ASSERT(here.curvature >= 0.0);
  RC_ASSERT(up.slope >= down.slope - 1e-12);
  // convex: the tangent lies below
  const double elsewhere = number(-50, 50);
  RC_ASSERT(psi(elsewhere, sigma, g1, g2) >= here.value + here.slope * (elsewhere - d) - 1e-9);
}

RC_GTEST_PROP(WorstCaseShortage, IsAboveTheHingeAndDecreasesToIt, ()) {
  const double sigma = number(1, 20);
  const double g1 = number(0, 3);
  const double g2 = number(0, 3);
  const double d = number(-50, 50);
  const double hinge = std::max(0.0, -d);
  double before = psi(d, sigma, g1, g2);
  for (const double factor : {0.5, 0.1, 1e-4, 1e-10}) {
    const double after = psi(d, sigma, factor * g1, factor * g2);
    RC_ASSERT(after <= before + 1e-12);
    RC_ASSERT(after >= hinge - 1e-12);
    before = after;
  }
  RC_ASSERT(before - hinge < 1e-3);
  RC_ASSERT(psi(d, sigma, 0.0, 0.0) == hinge);
}

}  // namespace
}  // namespace evbal

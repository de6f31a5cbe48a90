#include "coordinator/filter/count_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

TEST(CountLaw, IsSurprisedByTheTailOfAPoissonCount) {
  EXPECT_EQ(surprise(0, 0.3, 0), 0.0);
  EXPECT_NEAR(surprise(1, 0.3, 0), -std::log(1.0 - std::exp(-0.3)), 1e-12);
  EXPECT_NEAR(surprise(3, 0.3, 0), -std::log(1.0 - std::exp(-0.3) * (1.0 + 0.3 + 0.045)), 1e-9);
  EXPECT_NEAR(surprise(5, 0.3, 2), surprise(3, 0.3, 0), 1e-12) << "two more could come";
  EXPECT_EQ(surprise(2, 0.3, 2), 0.0);
  EXPECT_EQ(surprise(-2, 0.3, 0), 12.0);
}

TEST(CountLaw, FindsTheRightFarTails) {
  // Of a mean of 1 the chance of 40 or more is that of 40, within a fortieth.
  EXPECT_NEAR(surprise(40, 1.0, 0), 1.0 + std::lgamma(41.0), 0.03);
  EXPECT_GT(surprise(1'000'000, 0.3, 0), 1e6);
}

TEST(CountLaw, LeavesAFortiethAtEitherEnd) {
  for (const double mean : {0.01, 0.3, 1.0, 4.0, 30.0}) {
    const UsualCounts usual = usual_counts(mean);
    double below = 0.0;
    double within = 0.0;
    for (int k = 0; k <= usual.high; ++k) {
      (k < usual.low ? below : within) += std::exp(log_probability(k, mean, 0));
    }
    EXPECT_LE(below, 0.025);
    EXPECT_GE(within, 1.0 - 0.025 - below - 1e-12);
    if (mean >= 0.02) {
      EXPECT_NEAR(within, usual.probability, 1e-12) << mean;
    }
  }
}

}  // namespace
}  // namespace evbal

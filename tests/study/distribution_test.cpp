#include "experiments/study/statistics/distribution.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(Distribution, IsLinearBetweenOrderStatistics) {
  const Distribution d = distribution_of({9, 1, 5, 3, 7});
  EXPECT_EQ(d.min, 1.0);
  EXPECT_EQ(d.q1, 3.0);
  EXPECT_EQ(d.median, 5.0);
  EXPECT_EQ(d.q3, 7.0);
  EXPECT_DOUBLE_EQ(d.p90, 8.2);
  EXPECT_EQ(d.max, 9.0);
  EXPECT_EQ(d.mean, 5.0);
}

TEST(Distribution, OfOneValueIsThatValue) {
  for (const auto& [name, value] : named(distribution_of({4.0}))) {
    EXPECT_EQ(value, 4.0) << name;
  }
}

TEST(Distribution, TheWorstIsTheFirstOfItsKind) {
  EXPECT_EQ(worst_of({2, 5, 1, 5, 1}, true), 1U);
  EXPECT_EQ(worst_of({2, 5, 1, 5, 1}, false), 2U);
}

}  // namespace
}  // namespace evbal

#include "experiments/study/statistics/front_gap.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace evbal {
namespace {

std::vector<FrontPoint> any_front() {
  const int points = *rc::gen::inRange(2, 7);
  std::vector<FrontPoint> front;
  for (int i = 0; i < points; ++i) {
    front.push_back({*rc::gen::inRange(0, 100) / 1.0, *rc::gen::inRange(0, 1000) / 2.0});
  }
  return front;
}

/// The mean of ln((a + 1/2) / (b + 1/2)) by the midpoint rule.
double summed_log_ratio(const std::vector<FrontPoint>& a, const std::vector<FrontPoint>& b, const FrontGap& gap) {
  constexpr int steps = 20'000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double cost = gap.from + (gap.to - gap.from) * (i + 0.5) / steps;
    sum += std::log((*value_at(a, cost) + 0.5) / (*value_at(b, cost) + 0.5));
  }
  return sum / steps;
}

TEST(LowerHull, LeavesOutWhatAnotherPointOrALineBetters) {
  const auto hull = lower_hull({{40, 9}, {10, 100}, {20, 60}, {30, 10}, {20, 50}, {25, 60}, {10, 90}});
  ASSERT_EQ(hull.size(), 3);
  EXPECT_EQ(hull[0].value, 90);  // 20 km, 50 lost lies on the line
  EXPECT_EQ(hull[1].cost, 30);
  EXPECT_EQ(hull[2].cost, 40);
}

RC_GTEST_PROP(LowerHull, LiesBelowEveryPointAndIsConvex, ()) {
  const auto front = any_front();
  const auto hull = lower_hull(front);
  for (const FrontPoint& point : front) {
    const auto value = value_at(hull, std::min(point.cost, hull.back().cost));
    RC_ASSERT(value.has_value());
    RC_ASSERT(*value <= point.value + 1e-9);
  }
  for (std::size_t i = 2; i < hull.size(); ++i) {
    const double before = (hull[i - 1].value - hull[i - 2].value) / (hull[i - 1].cost - hull[i - 2].cost);
    const double after = (hull[i].value - hull[i - 1].value) / (hull[i].cost - hull[i - 1].cost);
    RC_ASSERT(before < after);
    RC_ASSERT(after < 0.0);
  }
}

RC_GTEST_PROP(FrontGap, IsTheMeanLogOfTheRatio, ()) {
  const auto a = lower_hull(any_front());
  const auto b = lower_hull(any_front());
  const auto gap = front_gap(a, b);
  const auto back = front_gap(b, a);
  RC_ASSERT(gap.has_value() == back.has_value());
  RC_PRE(gap.has_value());
  const double log_ratio = mean_log_ratio(a, b, *gap);
  RC_ASSERT(std::abs(log_ratio + mean_log_ratio(b, a, *back)) < 1e-9);
  RC_ASSERT(std::abs(log_ratio - summed_log_ratio(a, b, *gap)) < 1e-3);
  RC_ASSERT(std::abs(gap->value - back->reference) < 1e-9);
}

TEST(FrontGap, OfAPointIsTakenAtItsOwnCost) {
  const std::vector<FrontPoint> front = {{10, 100}, {20, 60}};
  const auto gap = front_gap({{15, 40}}, front, true);
  ASSERT_TRUE(gap.has_value());
  EXPECT_EQ(gap->reference, 80);
  EXPECT_DOUBLE_EQ(mean_log_ratio({{15, 40}}, front, *gap), std::log(40.5 / 80.5));
  EXPECT_EQ(front_gap(front, {{15, 40}}, true)->value, 80);
  EXPECT_FALSE(front_gap({{21, 40}}, front, true));
  EXPECT_FALSE(front_gap({{15, 40}}, front)) << "a front that shrank to a point on some day covers no range";
}

TEST(FrontGap, IsNoneWithoutARangeInCommon) {
  EXPECT_FALSE(front_gap({{10, 5}, {20, 1}}, {{20, 5}, {30, 1}}));
  EXPECT_FALSE(front_gap({}, {{20, 5}, {30, 1}}));
}

}  // namespace
}  // namespace evbal

#include "experiments/study/statistics/front_comparison.hpp"

#include "common/error.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace evbal {
namespace {

FinishedDay played(const std::string& variant, const std::string& price, const std::string& day, std::uint64_t seed,
                   double km, double lost) {
  FinishedDay finished{.scenario = "toy", .variant = variant, .faults = "calm", .day = day, .seed = seed};
  finished.settings = {{"price", price}};
  finished.totals = {{"idle_km", km}, {"lost", lost}};
  return finished;
}

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
  RC_ASSERT(std::abs(gap->log_ratio + back->log_ratio) < 1e-9);
  RC_ASSERT(std::abs(gap->log_ratio - summed_log_ratio(a, b, *gap)) < 1e-3);
  RC_ASSERT(std::abs(gap->value - back->reference) < 1e-9);
}

TEST(FrontGap, OfAPointIsTakenAtItsOwnCost) {
  const std::vector<FrontPoint> front = {{10, 100}, {20, 60}};
  const auto gap = front_gap({{15, 40}}, front, true);
  ASSERT_TRUE(gap.has_value());
  EXPECT_EQ(gap->reference, 80);
  EXPECT_DOUBLE_EQ(gap->log_ratio, std::log(40.5 / 80.5));
  EXPECT_DOUBLE_EQ(front_gap(front, {{15, 40}}, true)->log_ratio, -gap->log_ratio);
  EXPECT_FALSE(front_gap({{21, 40}}, front, true));
  EXPECT_FALSE(front_gap({{15, 40}}, front)) << "a front that shrank to a point on some day covers no range";
}

TEST(FrontGap, IsNoneWithoutARangeInCommon) {
  EXPECT_FALSE(front_gap({{10, 5}, {20, 1}}, {{20, 5}, {30, 1}}));
  EXPECT_FALSE(front_gap({}, {{20, 5}, {30, 1}}));
}

/// `new` loses half as many as `ref` and 1/4 fewer, all above 1/2, on two days of two seeds; on a third they are apart.
std::vector<FinishedDay> days_at_half() {
  std::vector<FinishedDay> days;
  for (const std::uint64_t seed : {1, 2}) {
    for (const auto& [day, lost] : {std::pair("d1", 100.0), std::pair("d2", 200.0)}) {
      days.push_back(played("ref", "1", day, seed, 10, lost));
      days.push_back(played("ref", "2", day, seed, 20, lost / 2));
      days.push_back(played("ref", "3", day, seed, 25, lost));  // drives farther and loses more: no part of the front
      days.push_back(played("new", "1", day, seed, 10, 0.5 * (lost + 0.25) - 0.25));
      days.push_back(played("new", "2", day, seed, 20, 0.5 * (lost / 2 + 0.25) - 0.25));
    }
    days.push_back(played("ref", "1", "d3", seed, 10, 4));
    days.push_back(played("ref", "2", "d3", seed, 20, 2));
    days.push_back(played("new", "1", "d3", seed, 21, 0));
    days.push_back(played("new", "2", "d3", seed, 22, 1));
  }
  days.push_back(played("new", "1", "d1", 3, 1, 0));  // a seed that the reference lacks
  return days;
}

TEST(ComparedFronts, AreSummedOverSeedsAndMeasuredByDay) {
  const auto rows = compare_fronts(days_at_half(), {.reference = "ref"});
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows[0].variant, "new");
  EXPECT_EQ(rows[0].days, 2);
  EXPECT_EQ(rows[0].apart, 1);
  EXPECT_DOUBLE_EQ(rows[0].covered, 1.0);
  EXPECT_NEAR(rows[0].ratio.mean, -0.5, 1e-12);
  EXPECT_NEAR(rows[0].ratio.low, -0.5, 1e-9);
  EXPECT_DOUBLE_EQ(rows[0].reference, 150 + 300);
  EXPECT_FALSE(rows[0].way.has_value());
}

TEST(ComparedFronts, SayHowFarItIsToTheBound) {
  auto days = days_at_half();
  for (const std::uint64_t seed : {1, 2}) {
    days.push_back(played("bound", "", "d1", seed, 5, 30));
    days.push_back(played("bound", "", "d1", seed, 10, 0));
  }
  const auto rows = compare_fronts(days, {.reference = "ref", .bound = "bound"});
  ASSERT_EQ(rows.size(), 1);
  ASSERT_TRUE(rows[0].way.has_value());
  EXPECT_NEAR(*rows[0].way, (150.0 - (75.0 - 0.25)) / 150.0, 1e-12);  // of the first day only

  days.pop_back();
  days.pop_back();  // and now of its first seed only
  EXPECT_NEAR(compare_fronts(days, {.reference = "ref", .bound = "bound"}).at(0).way.value(), (75.0 - 37.375) / 75.0,
              1e-12);
}

TEST(ComparedFronts, ABoundOfSeveralSeedsSpendsWhereItSavesMost) {
  std::vector<FinishedDay> days;
  for (const std::uint64_t seed : {1, 2}) {
    days.push_back(played("ref", "1", "d1", seed, 10, 50));
    days.push_back(played("ref", "2", "d1", seed, 15, 40));
    days.push_back(played("new", "1", "d1", seed, 10, 45));
    days.push_back(played("new", "2", "d1", seed, 15, 35));
    days.push_back(played("bound", "", "d1", seed, 5, 40));
    days.push_back(played("bound", "", "d1", seed, 15, seed == 1 ? 0 : 30));
  }
  // 20 km in all leave 40 + 0, 30 km leave 30 + 0; half a km each would say more at 20.
  const auto rows = compare_fronts(days, {.reference = "ref", .bound = "bound"});
  ASSERT_TRUE(rows.at(0).way.has_value());
  EXPECT_NEAR(*rows[0].way, 10.0 / (90.0 - 35.0), 1e-12);
}

TEST(ComparedFronts, NameWhatIsUnknown) {
  EXPECT_THROW(compare_fronts(days_at_half(), {.reference = "reff"}), Error);
  EXPECT_THROW(compare_fronts(days_at_half(), {.metric = "lots", .reference = "ref"}), Error);
}

}  // namespace
}  // namespace evbal

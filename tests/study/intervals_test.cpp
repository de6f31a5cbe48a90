#include "experiments/study/statistics/intervals.hpp"

#include "experiments/study/statistics/front.hpp"
#include "experiments/study/statistics/ranks.hpp"
#include "tests/study/r_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace evbal {
namespace {

/// What R made of the same numbers (intervals.R), by kind of line.
class AgainstR : public ::testing::Test {
 protected:
  AgainstR() {
    for (const auto& [kind, numbers] : test::r_lines("tests/study/intervals.csv")) {
      lines_[kind].push_back(numbers);
    }
  }

  std::vector<DayValue> values() const {
    std::vector<DayValue> all;
    for (const auto& line : lines_.at("value")) {
      all.push_back({std::to_string(line[0]), line[1]});
    }
    return all;
  }

  std::map<std::string, std::vector<std::vector<double>>> lines_;
};

void expect_near(const Interval& interval, const std::vector<double>& expected, double tolerance) {
  EXPECT_NEAR(interval.mean, expected[0], 1e-12);
  EXPECT_NEAR(interval.low, expected[1], tolerance);
  EXPECT_NEAR(interval.high, expected[2], tolerance);
}

TEST_F(AgainstR, IntervalsAgree) {
  expect_near(t_interval(values()), lines_.at("t").at(0), 1e-12);
}

TEST_F(AgainstR, TestsAgree) {
  EXPECT_NEAR(t_test(values()) / lines_.at("p").at(0).at(0), 1.0, 1e-9);
  std::vector<DayValue> shifted = values();
  for (auto& value : shifted) {
    value.value += 0.19;
  }
  EXPECT_NEAR(t_test(shifted), lines_.at("p").at(1).at(0), 1e-12);
  const auto adjusted = holm(lines_.at("family").at(0));
  ASSERT_EQ(adjusted.size(), 6);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    EXPECT_NEAR(adjusted[i], lines_.at("holm").at(0).at(i), 1e-15);
  }
}

TEST_F(AgainstR, RankCorrelationsAgree) {
  const std::vector<double> x = lines_.at("ranks_x").at(0);
  EXPECT_NEAR(rank_correlation(x, lines_.at("ranks_y").at(0)), lines_.at("ranks").at(0).at(0), 1e-12);
  EXPECT_EQ(rank_correlation(x, std::vector<double>(x.size(), 1.0)), 0.0);
}

TEST_F(AgainstR, QuantilesOfStudentsTAgree) {
  ASSERT_EQ(lines_.at("student").size(), 6);
  for (const auto& line : lines_.at("student")) {
    EXPECT_NEAR(student_t(line[0], static_cast<int>(line[1])), line[2], 1e-9 * line[2]) << line[1];
  }
}

TEST_F(AgainstR, FrontsAreInterpolatedAndNotExtrapolated) {
  std::vector<FrontPoint> front;
  for (const auto& line : lines_.at("point")) {
    front.push_back({line[0], line[1]});
  }
  std::sort(front.begin(), front.end(), [](const FrontPoint& a, const FrontPoint& b) { return a.cost < b.cost; });
  ASSERT_EQ(lines_.at("at").size() + lines_.at("outside").size(), 7);
  for (const auto& line : lines_.at("at")) {
    ASSERT_TRUE(value_at(front, line[0])) << line[0];
    EXPECT_NEAR(*value_at(front, line[0]), line[1], 1e-9) << line[0];
  }
  for (const auto& line : lines_.at("outside")) {
    EXPECT_FALSE(value_at(front, line[0])) << line[0];
  }
}

TEST(Intervals, CountADayOnceHoweverManySeedsItHas) {
  const std::vector<DayValue> even = {{"a", 1}, {"b", 3}};
  const std::vector<DayValue> uneven = {{"a", 1}, {"b", 2}, {"b", 3}, {"b", 4}};
  EXPECT_EQ(t_interval(even).mean, 2.0);
  EXPECT_EQ(t_interval(uneven).mean, 2.0);
  EXPECT_DOUBLE_EQ(t_interval(uneven).high, t_interval(even).high);
}

TEST(Intervals, OfOneDayAreInfinite) {
  const std::vector<DayValue> one = {{"a", 1}, {"a", 2}};
  EXPECT_EQ(t_interval(one).mean, 1.5);
  EXPECT_TRUE(std::isinf(t_interval(one).low));
  EXPECT_EQ(t_test(one), 1.0);
}

TEST(Intervals, OfDaysThatAgreeExactlyAreNotKnown) {
  const std::vector<DayValue> agreeing = {{"a", -0.25}, {"b", -0.25}};
  EXPECT_EQ(t_interval(agreeing).mean, -0.25);
  EXPECT_FALSE(is_known(t_interval(agreeing)));
  EXPECT_EQ(t_test(agreeing), 1.0);
  const std::vector<DayValue> but_for_rounding = {{"a", 0.1 + 0.2}, {"b", 0.3}, {"c", 0.3}};
  EXPECT_EQ(t_test(but_for_rounding), 1.0);
  const std::vector<DayValue> no_difference = {{"a", 0.0}, {"b", 0.0}};
  EXPECT_EQ(t_interval(no_difference).high, 0.0);
  EXPECT_EQ(t_test(no_difference), 1.0);
}

}  // namespace
}  // namespace evbal

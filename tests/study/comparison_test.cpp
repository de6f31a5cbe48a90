#include "experiments/study/statistics/comparison.hpp"

#include "common/error.hpp"
#include "tests/study/r_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace evbal {
namespace {

FinishedDay day_of(const std::string& variant, const std::string& price, const std::string& day, std::uint64_t seed,
                   double km, double lost) {
  FinishedDay finished{.scenario = "toy", .variant = variant, .faults = "calm", .day = day, .seed = seed};
  finished.settings = {{"engine", "cuts"}, {"price", price}};
  finished.totals = {{"idle_km", km}, {"lost", lost}, {"stranded", 0.0}, {"unserved_ratio", lost / 1000.0}};
  return finished;
}

const Question at_equal_km{.metric = "lost", .reference = "ref", .at = "idle_km"};
const Question plainly{.metric = "lost", .reference = "ref", .at = {}};

/// The reference loses 100 at 10 km and 50 at 20 km on the first day, twice as many on the second.
std::vector<FinishedDay> days_at_two_settings() {
  return {day_of("ref", "1", "d1", 1, 10, 100), day_of("ref", "2", "d1", 1, 20, 50),
          day_of("ref", "1", "d2", 1, 10, 200), day_of("ref", "2", "d2", 1, 20, 100),
          day_of("new", "1", "d1", 1, 12, 45),  day_of("new", "2", "d1", 1, 18, 42),
          day_of("new", "1", "d2", 1, 12, 135), day_of("new", "2", "d2", 1, 21, 60)};
}

/// exp of the mean of ln((value + 1/2) / (reference + 1/2)), less 1.
double ratio_of(const std::vector<std::pair<double, double>>& days) {
  double sum = 0.0;
  for (const auto& [value, reference] : days) {
    sum += std::log((value + 0.5) / (reference + 0.5));
  }
  return std::exp(sum / static_cast<double>(days.size())) - 1.0;
}

TEST(Comparison, HoldsASettingAgainstTheFrontAtItsOwnCost) {
  const auto rows = compare(days_at_two_settings(), at_equal_km);
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[0].variant, "new");
  EXPECT_EQ(rows[0].settings, "price=1");
  EXPECT_EQ(rows[0].days, 2);
  EXPECT_EQ(rows[0].inside, 2);
  EXPECT_EQ(rows[0].from, 12);
  EXPECT_EQ(rows[0].to, 12);
  EXPECT_EQ(rows[0].value, 45 + 135);
  EXPECT_DOUBLE_EQ(rows[0].reference, 90 + 180);
  EXPECT_NEAR(rows[0].difference.mean, ratio_of({{45, 90}, {135, 180}}), 1e-12);
  EXPECT_EQ(rows[1].days, 1);  // 21 km lie outside of the second day's front
  EXPECT_EQ(rows[1].apart, 1);
  EXPECT_NEAR(rows[1].difference.mean, ratio_of({{42, 60}}), 1e-12);
  EXPECT_TRUE(std::isinf(rows[1].difference.low));
  EXPECT_TRUE(rows[2].whole);
  EXPECT_EQ(rows[2].settings, "");
  EXPECT_EQ(rows[2].points, 4);
  EXPECT_EQ(rows[2].inside, 3);
  EXPECT_DOUBLE_EQ(rows[2].covered, (0.6 + 0.8) / 2);
}

TEST(Comparison, IsPlainlyPairedAgainstOneSetting) {
  std::vector<FinishedDay> days = days_at_two_settings();
  EXPECT_THROW(compare(days, plainly), Error);
  std::erase_if(days, [](const FinishedDay& day) { return day.variant == "ref" && day.settings.at("price") == "2"; });
  const auto rows = compare(days, plainly);
  ASSERT_EQ(rows.size(), 2) << "settings of a variant are not thrown together where they have no front";
  EXPECT_EQ(rows[1].days, 2);
  EXPECT_NEAR(rows[1].difference.mean, ratio_of({{42, 100}, {60, 200}}), 1e-12);
}

TEST(Comparison, TakesCostAtEqualServiceToo) {
  const auto rows = compare(days_at_two_settings(), {.metric = "idle_km", .reference = "ref", .at = "lost"});
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[0].days, 1);  // on the first day the reference never loses as few as 45
  EXPECT_DOUBLE_EQ(rows[0].reference, 16.5);
  EXPECT_NEAR(rows[0].difference.mean, ratio_of({{12, 16.5}}), 1e-12);
  EXPECT_EQ(rows[1].days, 0);
}

TEST(Comparison, SumsSeedsAndTakesDaysAsTheSample) {
  std::vector<FinishedDay> days;
  for (const auto& [day, seed, reference, lost] : {std::tuple("d1", 1, 10, 90), std::tuple("d1", 2, 190, 10),
                                                   std::tuple("d2", 1, 100, 45), std::tuple("d2", 2, 100, 45)}) {
    days.push_back(day_of("ref", "1", day, seed, 10, reference));
    days.push_back(day_of("new", "1", day, seed, 10, lost));
  }
  const auto rows = compare(days, plainly);
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows[0].days, 2);
  EXPECT_EQ(rows[0].value, 190);
  EXPECT_NEAR(rows[0].difference.mean, ratio_of({{100, 200}, {90, 200}}), 1e-12);
}

TEST(Comparison, DoesNotContradictItsTotals) {
  const auto rows = compare({day_of("ref", "1", "d1", 1, 10, 10), day_of("ref", "1", "d2", 1, 10, 100),
                             day_of("new", "1", "d1", 1, 10, 20), day_of("new", "1", "d2", 1, 10, 30)},
                            plainly);
  ASSERT_EQ(rows.size(), 1);
  EXPECT_LT(of_totals(rows[0]).value(), 0.0);
  EXPECT_LT(rows[0].difference.mean, 0.0) << "twice as many of few, and less than a third of many";
}

/// The reference's front from 10 to 20 km; another variant with two of three prices beyond it, on three days.
std::vector<FinishedDay> days_mostly_outside() {
  std::vector<FinishedDay> days;
  for (const auto& [day, level] : {std::pair("d1", 1.0), std::pair("d2", 1.1), std::pair("d3", 0.9)}) {
    days.push_back(day_of("ref", "1", day, 1, 10, 100 * level));
    days.push_back(day_of("ref", "2", day, 1, 20, 50));
    days.push_back(day_of("new", "1", day, 1, 14, 60));
    days.push_back(day_of("new", "2", day, 1, 24, 40));
    days.push_back(day_of("new", "3", day, 1, 30, 35));
  }
  return days;
}

TEST(Comparison, CountsPointsInsideAsPoints) {
  const auto rows = compare(days_mostly_outside(), at_equal_km);
  ASSERT_EQ(rows.size(), 4);
  EXPECT_EQ(rows[3].points, 9);
  EXPECT_EQ(rows[3].inside, 3);
  EXPECT_EQ(rows[0].inside, 3);
  EXPECT_EQ(rows[1].inside, 0);
  EXPECT_EQ(rows[1].apart, 3);
}

TEST(Comparison, OfWholeFrontsDoesNotDependOnPricesThatAddNothing) {
  std::vector<FinishedDay> days = days_mostly_outside();
  const Compared before = compare(days, at_equal_km).back();
  for (const std::string day : {"d1", "d2", "d3"}) {
    days.push_back(day_of("new", "4", day, 1, 15, 90));    // bettered by the first
    days.push_back(day_of("new", "5", day, 1, 14.5, 59));  // on the line from the first to the second
    days.push_back(day_of("ref", "6", day, 1, 13, 400));   // of the reference, bettered too
  }
  const Compared after = compare(days, at_equal_km).back();
  EXPECT_NEAR(after.difference.mean, before.difference.mean, 1e-12);
  EXPECT_NEAR(after.difference.low, before.difference.low, 1e-12);
  EXPECT_NEAR(after.from, before.from, 1e-12);
  EXPECT_NEAR(after.value, before.value, 1e-9);
}

TEST(Comparison, DoesNotInterpolateThroughDominatedPoints) {
  std::vector<FinishedDay> days = days_mostly_outside();
  for (const std::string day : {"d1", "d2", "d3"}) {
    days.push_back(day_of("ref", "3", day, 1, 15, 300));
  }
  EXPECT_DOUBLE_EQ(compare(days, at_equal_km).front().reference, (100 + 110 + 90) * 0.6 + 3 * 50 * 0.4);
}

TEST(Comparison, ReadsOtherMetricsAlongTheFront) {
  std::vector<FinishedDay> days = days_mostly_outside();
  for (FinishedDay& day : days) {
    day.totals["unserved_ratio"] = day.totals.at("idle_km");  // more where more is driven
  }
  const Compared row = compare(days, {.metric = "unserved_ratio", .reference = "ref", .at = "idle_km"}).back();
  EXPECT_EQ(row.days, 3);
  EXPECT_FALSE(row.relative) << "of shares and means, which a ratio does not suit";
  EXPECT_DOUBLE_EQ(row.value, 17.0) << "from 14 to 20 km";
  EXPECT_NEAR(row.difference.mean, 0.0, 1e-12);
}

TEST(Comparison, OfDaysThatAgreeExactlyShowsNothing) {
  const auto rows = compare({day_of("ref", "1", "d1", 1, 10, 80), day_of("ref", "1", "d2", 1, 10, 80),
                             day_of("new", "1", "d1", 1, 10, 40), day_of("new", "1", "d2", 1, 10, 40)},
                            plainly);
  EXPECT_NEAR(rows[0].difference.mean, ratio_of({{40, 80}}), 1e-12);
  EXPECT_EQ(rows[0].p, 1.0);
  EXPECT_FALSE(is_known(rows[0].difference));
}

TEST(Comparison, KeepsItsUnitWhenTheReferenceIsZero) {
  const auto rows = compare({day_of("ref", "1", "d1", 1, 10, 0), day_of("ref", "1", "d2", 1, 10, 100),
                             day_of("new", "1", "d1", 1, 10, 1), day_of("new", "1", "d2", 1, 10, 50)},
                            plainly);
  EXPECT_TRUE(rows[0].relative);
  EXPECT_NEAR(rows[0].difference.mean, ratio_of({{1, 0}, {50, 100}}), 1e-12);
}

TEST(Comparison, PairsOnlyWhatBothHave) {
  std::vector<FinishedDay> days = days_at_two_settings();
  for (const auto& day : {day_of("new", "1", "d1", 2, 12, 1), day_of("new", "1", "d3", 1, 12, 1)}) {
    days.push_back(day);
  }
  const auto rows = compare(days, at_equal_km);
  EXPECT_EQ(rows[0].days, 2);
  EXPECT_EQ(rows[0].points, 2);
  EXPECT_EQ(rows[0].value, 45 + 135);
}

TEST(Comparison, KeepsScenariosApart) {
  std::vector<FinishedDay> days = days_at_two_settings();
  for (FinishedDay day : days_at_two_settings()) {
    day.scenario = "other";
    days.push_back(day);
  }
  const auto rows = compare(days, at_equal_km);
  ASSERT_EQ(rows.size(), 6);
  EXPECT_EQ(rows[3].scenario, "other");
  EXPECT_EQ(rows[3].days, 2);
}

TEST(Comparison, SaysWhichSwitchDiffers) {
  const auto rows = compare({day_of("base", "1", "d1", 1, 10, 100), day_of("base", "1", "d2", 1, 10, 100),
                             day_of("dear", "2", "d1", 1, 10, 80), day_of("dear", "2", "d2", 1, 10, 60),
                             day_of("free", "", "d1", 1, 10, 101), day_of("free", "", "d2", 1, 10, 99)},
                            {.metric = "lost", .reference = "base", .at = {}});
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[0].settings, "price=2");
  EXPECT_TRUE(rows[0].whole);
  EXPECT_EQ(rows[1].settings, "price=default");
}

TEST(Comparison, SaysHowFarItIsToTheBound) {
  std::vector<FinishedDay> days;
  for (const std::uint64_t seed : {1, 2}) {
    days.push_back(day_of("ref", "1", "d1", seed, 10, 50));
    days.push_back(day_of("ref", "2", "d1", seed, 15, 40));
    days.push_back(day_of("new", "1", "d1", seed, 10, 45));
    days.push_back(day_of("new", "2", "d1", seed, 15, 35));
    days.push_back(day_of("bound", "", "d1", seed, 5, 40));
    days.push_back(day_of("bound", "", "d1", seed, 15, seed == 1 ? 0 : 30));
  }
  // 20 km in all leave 40 + 0, 30 km leave 30 + 0; half a km each would say more at 20.
  Question question{.metric = "lost", .reference = "ref", .at = "idle_km", .bound = "bound"};
  const auto rows = compare(days, question);
  ASSERT_TRUE(rows.back().way.has_value());
  EXPECT_NEAR(*rows.back().way, 10.0 / (90.0 - 35.0), 1e-12);
  EXPECT_NEAR(rows.front().way.value(), 10.0 / (100.0 - 40.0), 1e-12) << "a single setting, at its own km";

  question.reference = "bound";
  const auto against = compare(days, question);
  EXPECT_EQ(against.front().variant, "ref");
  EXPECT_FALSE(against.front().relative) << "the bound may be next to nothing";
  EXPECT_DOUBLE_EQ(against.front().difference.mean, (100.0 - 40.0) / 2) << "a day and seed";
}

TEST(Comparison, TakesTheWayOfDaysAndSeedsThatHaveABound) {
  std::vector<FinishedDay> days;
  for (const std::uint64_t seed : {1, 2}) {
    for (const auto& [day, lost] : {std::pair("d1", 100.0), std::pair("d2", 200.0)}) {
      days.push_back(day_of("ref", "1", day, seed, 10, lost));
      days.push_back(day_of("ref", "2", day, seed, 20, lost / 2));
      days.push_back(day_of("new", "1", day, seed, 10, seed == 1 ? 40 : 60));
      days.push_back(day_of("new", "2", day, seed, 20, seed == 1 ? 20 : 30));
    }
  }
  for (const std::uint64_t seed : {1, 2}) {
    days.push_back(day_of("bound", "", "d1", seed, 5, 30));
    days.push_back(day_of("bound", "", "d1", seed, 10, 0));
  }
  const Question question{.metric = "lost", .reference = "ref", .at = "idle_km", .bound = "bound"};
  EXPECT_NEAR(compare(days, question).back().way.value(), (150.0 - 75.0) / 150.0, 1e-12);
  days.pop_back();
  days.pop_back();
  EXPECT_NEAR(compare(days, question).back().way.value(), (75.0 - 30.0) / 75.0, 1e-12);
  EXPECT_FALSE(compare(days, at_equal_km).back().way.has_value());
}

TEST(Comparison, RefusesWhatItCannotAnswer) {
  const auto refuse = [](const Question& question, const std::string& word) {
    try {
      compare(days_at_two_settings(), question);
      FAIL() << word;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refuse({.metric = "lots", .reference = "ref", .at = "idle_km"}, "did you mean `lost`");
  refuse({.metric = "lost", .reference = "reff", .at = "idle_km"}, "did you mean `ref`");
  refuse({.metric = "lost", .reference = "ref", .at = "idle"}, "nothing to compare at");
  refuse({.metric = "lost", .reference = "ref", .at = "stranded"}, "`idle_km` and `lost` are");
  refuse(plainly, "--at");
}

/// What R made of the same days (comparison.R).
class ComparisonAgainstR : public ::testing::Test {
 protected:
  ComparisonAgainstR() {
    for (const auto& [kind, line] : test::r_lines("tests/study/comparison.csv")) {
      const std::vector<double>& numbers = line;
      if (kind == "ref" || kind == "new") {
        const auto whole = [&](std::size_t i) { return std::to_string(static_cast<int>(numbers[i])); };
        days_.push_back(
            day_of(kind, whole(1), whole(0), static_cast<std::uint64_t>(numbers[2]), numbers[3], numbers[4]));
        days_.back().totals["passenger_wait_min"] = numbers[5];
      } else {
        answers_[kind] = numbers;
      }
    }
  }

  void expect(const Compared& row, const std::string& kind) const {
    const std::vector<double> found = {static_cast<double>(row.days),
                                       static_cast<double>(row.apart),
                                       static_cast<double>(row.points),
                                       static_cast<double>(row.inside),
                                       row.covered,
                                       row.value,
                                       row.reference,
                                       row.difference.mean,
                                       row.difference.low,
                                       row.difference.high,
                                       row.p};
    const std::vector<double>& right = answers_.at(kind);
    ASSERT_EQ(right.size(), found.size());
    for (std::size_t i = 0; i < right.size(); ++i) {
      EXPECT_NEAR(found[i], right[i], 1e-9 * std::max(1.0, std::abs(right[i]))) << kind << ", column " << i;
    }
  }

  std::vector<FinishedDay> days_;
  std::map<std::string, std::vector<double>> answers_;
};

TEST_F(ComparisonAgainstR, WholeFrontsAgree) {
  expect(compare(days_, at_equal_km).back(), "fronts");
}

TEST_F(ComparisonAgainstR, FrozenSettingsAgree) {
  const auto rows = compare(days_, at_equal_km);
  ASSERT_EQ(rows[1].settings, "price=2");
  expect(rows[1], "frozen");
}

TEST_F(ComparisonAgainstR, PlainDifferencesAlongTheFrontAgree) {
  expect(compare(days_, {.metric = "passenger_wait_min", .reference = "ref", .at = "idle_km"}).back(), "waits");
}

}  // namespace
}  // namespace evbal

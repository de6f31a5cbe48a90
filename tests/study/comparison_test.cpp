#include "experiments/study/statistics/comparison.hpp"

#include "common/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

FinishedDay day_of(const std::string& variant, const std::string& price, const std::string& day, std::uint64_t seed,
                   double km, double lost) {
  FinishedDay finished{.variant = variant, .faults = "calm", .day = day, .seed = seed};
  finished.settings = {{"engine", "cuts"}, {"price", price}};
  finished.totals = {{"idle_km", km}, {"lost", lost}, {"served", 100.0}, {"stranded", 0.0}};
  return finished;
}

/// The reference loses 100 at 10 km and 50 at 20 km on the first day, twice as many on the second.
std::vector<FinishedDay> days_at_two_settings() {
  return {day_of("ref", "1", "d1", 1, 10, 100), day_of("ref", "2", "d1", 1, 20, 50),
          day_of("ref", "1", "d2", 1, 10, 200), day_of("ref", "2", "d2", 1, 20, 100),
          day_of("new", "1", "d1", 1, 12, 45),  day_of("new", "2", "d1", 1, 18, 42),
          day_of("new", "1", "d2", 1, 12, 135), day_of("new", "2", "d2", 1, 21, 60)};
}

TEST(Comparison, IsMadeAtEqualCostAndWithinTheFrontOnly) {
  const auto rows = compare(days_at_two_settings(), {.metric = "lost", .reference = "ref", .at = "idle_km"});
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[0].variant, "new");
  EXPECT_EQ(rows[0].settings, "price=1");
  EXPECT_EQ(rows[0].pairs, 2);
  EXPECT_EQ(rows[0].outside, 0);
  EXPECT_DOUBLE_EQ(rows[0].at, 12);
  EXPECT_DOUBLE_EQ(rows[0].value, 90);
  EXPECT_DOUBLE_EQ(rows[0].reference, (90 + 180) / 2.0);
  EXPECT_DOUBLE_EQ(rows[0].by_t.mean, (-0.5 - 0.25) / 2);
  EXPECT_NEAR(rows[0].by_t.high - rows[0].by_t.mean, 12.706204736 * 0.125, 1e-8);
  EXPECT_EQ(rows[1].pairs, 1);  // 21 km lie outside of the second day's front
  EXPECT_EQ(rows[1].outside, 1);
  EXPECT_DOUBLE_EQ(rows[1].by_t.mean, 42.0 / 60.0 - 1.0);
  EXPECT_TRUE(std::isinf(rows[1].by_t.low));
  EXPECT_EQ(rows[2].settings, "");
  EXPECT_EQ(rows[2].pairs, 2);
  EXPECT_DOUBLE_EQ(rows[2].by_t.mean, ((-0.5 - 0.3) / 2 - 0.25) / 2);
}

TEST(Comparison, IsPlainlyPairedAgainstOneSetting) {
  std::vector<FinishedDay> days = days_at_two_settings();
  EXPECT_THROW(compare(days, {.metric = "lost", .reference = "ref", .at = {}}), Error);
  std::erase_if(days, [](const FinishedDay& day) { return day.variant == "ref" && day.settings.at("price") == "2"; });
  const auto rows = compare(days, {.metric = "lost", .reference = "ref", .at = {}});
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[1].pairs, 2);
  EXPECT_DOUBLE_EQ(rows[1].by_t.mean, ((0.42 - 1.0) + (0.3 - 1.0)) / 2);
}

TEST(Comparison, TakesCostAtEqualServiceToo) {
  const auto rows = compare(days_at_two_settings(), {.metric = "idle_km", .reference = "ref", .at = "lost"});
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[0].pairs, 1);  // on the first day the reference never loses as few as 45
  EXPECT_DOUBLE_EQ(rows[0].reference, 16.5);
  EXPECT_DOUBLE_EQ(rows[0].by_t.mean, 12.0 / 16.5 - 1.0);
  EXPECT_EQ(rows[1].pairs, 0);
}

TEST(Comparison, IsNotRelativeToNothing) {
  const auto rows = compare(days_at_two_settings(), {.metric = "stranded", .reference = "ref", .at = "idle_km"});
  ASSERT_EQ(rows.size(), 3);
  EXPECT_FALSE(rows[0].relative);
  EXPECT_EQ(rows[0].pairs, 2);
  EXPECT_EQ(rows[0].difference.mean, 0.0);
  EXPECT_EQ(rows[0].p, 1.0);
}

TEST(Comparison, PairsOnlyWhatBothHave) {
  std::vector<FinishedDay> days = days_at_two_settings();
  for (const auto& day : {day_of("new", "1", "d1", 2, 12, 1), day_of("new", "1", "d3", 1, 12, 1)}) {
    days.push_back(day);
  }
  const auto rows = compare(days, {.metric = "lost", .reference = "ref", .at = "idle_km"});
  EXPECT_EQ(rows[0].pairs, 2);
  EXPECT_EQ(rows[0].outside, 0);
}

TEST(Comparison, KeepsScenariosApart) {
  std::vector<FinishedDay> days = days_at_two_settings();
  for (FinishedDay day : days_at_two_settings()) {
    day.scenario = "other";
    days.push_back(day);
  }
  const auto rows = compare(days, {.metric = "lost", .reference = "ref", .at = "idle_km"});
  ASSERT_EQ(rows.size(), 6);
  EXPECT_EQ(rows[3].scenario, "other");
  EXPECT_EQ(rows[3].pairs, 2);
}

TEST(Comparison, SaysWhichSwitchDiffers) {
  std::vector<FinishedDay> days = {day_of("base", "1", "d1", 1, 10, 100), day_of("base", "1", "d2", 1, 10, 100),
                                   day_of("dear", "2", "d1", 1, 10, 80),  day_of("dear", "2", "d2", 1, 10, 60),
                                   day_of("free", "", "d1", 1, 10, 101),  day_of("free", "", "d2", 1, 10, 99)};
  const auto rows = compare(days, {.metric = "lost", .reference = "base", .at = {}});
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[0].settings, "price=2");
  EXPECT_EQ(rows[1].settings, "price=default");
  EXPECT_NEAR(rows[0].p, 0.2048327647, 1e-9);  // t = 3 with one degree of freedom
  EXPECT_DOUBLE_EQ(rows[0].p_holm, 2.0 * rows[0].p);
  EXPECT_EQ(rows[1].p_holm, 1.0);
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
  refuse({.metric = "lost", .reference = "ref", .at = "idle"}, "is no metric");
  refuse({.metric = "lost", .reference = "ref", .at = {}}, "--at");
}

}  // namespace
}  // namespace evbal

#include "experiments/study/design/day_filter.hpp"

#include "common/error.hpp"
#include "experiments/study/design/finished_day.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

const std::vector<FinishedDay> four_days = {
    {.scenario = "toy", .variant = "a", .faults = "calm", .day = "2024-01-11"},
    {.scenario = "toy", .variant = "b", .faults = "calm", .day = "2024-01-12"},
    {.scenario = "city", .variant = "a", .faults = "storm", .day = "2024-01-11"},
    {.scenario = "city", .variant = "b", .faults = "calm", .day = "2024-01-13"},
};

using Positions = std::vector<std::size_t>;

TEST(DayFilter, TakesDaysThatHaveANameOfEachList) {
  EXPECT_EQ(positions_of({}, four_days), (Positions{0, 1, 2, 3}));
  EXPECT_EQ(positions_of({.scenarios = {"city"}}, four_days), (Positions{2, 3}));
  EXPECT_EQ(positions_of({.faults = {"calm"}, .variants = {"b"}}, four_days), (Positions{1, 3}));
  EXPECT_EQ(positions_of({.days = {"2024-01-12", "2024-01-13"}}, four_days), (Positions{1, 3}));
  EXPECT_EQ(filtered({.faults = {"storm"}}, four_days).at(0).scenario, "city");
}

void expect_refused(const DayFilter& filter, const std::string& words) {
  try {
    positions_of(filter, four_days);
    FAIL() << "was accepted, expected: " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(DayFilter, RefusesNamesThatNoDayHasAndListsThoseThatThereAre) {
  expect_refused({.scenarios = {"toi"}}, "--scenario: `toi` is not in the sweep (did you mean `toy`?); there is `toy`");
  expect_refused({.faults = {"calm", "rain"}}, "--faults: `rain` is not in the sweep; there is `calm`, `storm`");
  expect_refused({.variants = {"c"}}, "there is `a`, `b`");
  expect_refused({.days = {"2024-02-11"}}, "--days: `2024-02-11` is not in the sweep");
  expect_refused({.scenarios = {"toy"}, .faults = {"storm"}}, "no day of the sweep has all of these");
}

}  // namespace
}  // namespace evbal

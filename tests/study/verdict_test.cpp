#include "experiments/study/statistics/verdict.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace evbal {
namespace {

FinishedDay asked_day(const std::string& scenario, const std::string& variant, const std::string& price, int date,
                      double km, double lost) {
  FinishedDay day{.scenario = scenario,
                  .variant = variant,
                  .controller = "ratio",
                  .faults = "calm",
                  .day = "d" + std::to_string(date)};
  day.seed = 1;
  day.settings = {{"price", price}};
  day.totals = {{"idle_km", km}, {"lost", lost}};
  return day;
}

/// Three days of a city, on which the rival loses 100 at 15 km, and `new` that many at `km`.
void add_city(std::vector<FinishedDay>& days, const std::string& scenario, const std::array<double, 3>& lost,
              double km = 15.0) {
  for (int date = 0; date < 3; ++date) {
    days.push_back(asked_day(scenario, "old", "1", date, 10.0, 120.0));
    days.push_back(asked_day(scenario, "old", "2", date, 20.0, 80.0));
    days.push_back(asked_day(scenario, "new", "1", date, km, lost[static_cast<std::size_t>(date)]));
  }
}

constexpr std::array fewer = {50.0, 51.0, 49.0};
constexpr std::array more = {200.0, 202.0, 198.0};
constexpr std::array unclear = {60.0, 100.0, 160.0};

/// The page of one question, asked of cities.
Page asking(const std::string& cities) {
  return read_page(YamlValue::parse("title: T\nsections: [{title: S}]\n"
                                    "names: {a: Aville, b: Btown, new: our planner, old: the rival}\n"
                                    "verdict:\n"
                                    "  - question: Does it pay?\n"
                                    "    fronts: {variants: [new], against: [old], primary: {scenarios: [" +
                                        cities + "]}}\n",
                                    "sweep.yaml"),
                   {{"old", "new"}, {"a", "b", "c"}, {"calm"}});
}

std::string verdict(const Page& page, const PageDays& days) {
  return verdict_text(page, days, primary_answers(page, days.days));
}

/// The verdict on two cities.
std::string on_two(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  std::vector<FinishedDay> days;
  add_city(days, "a", a);
  add_city(days, "b", b);
  return verdict(asking("a, b"), {days});
}

void expect_begin(const std::string& text, const std::string& begin) {
  EXPECT_TRUE(text.starts_with(begin)) << text;
}

TEST(Verdict, SaysInPlainWordsWhatIsShownWhere) {
  expect_begin(on_two(fewer, fewer),
               "**Does it pay? Yes.** Passengers lost at equal kilometres driven empty (fewer is better), our planner "
               "against the rival: "
               "Aville −49.8 % (−52.2 to −47.2 %) and Btown −49.8 % (−52.2 to −47.2 %).\n\n");
  expect_begin(on_two(more, more), "**Does it pay? No, it is worse.** ");
  expect_begin(on_two(unclear, unclear), "**Does it pay? Not shown.** ");
  expect_begin(on_two(fewer, unclear), "**Does it pay? In part: better in Aville; not shown in Btown.** ");
  expect_begin(on_two(unclear, more), "**Does it pay? No: worse in Btown; not shown in Aville.** ");
  expect_begin(on_two(more, fewer), "**Does it pay? Mixed: better in Btown; worse in Aville.** ");
}

TEST(Verdict, BeginsWithWhatIsAskedForReadersWhoKnowNothing) {
  std::vector<FinishedDay> days;
  add_city(days, "a", fewer);
  Page page = asking("a");
  page.introduction = "Where should cars go?";
  expect_begin(verdict(page, {days}), "Where should cars go?\n\n**Does it pay? Yes.** ");
}

TEST(Verdict, SaysWhereNothingCouldBeCompared) {
  std::vector<FinishedDay> days;
  add_city(days, "a", fewer);
  add_city(days, "b", fewer, 500.0);
  expect_begin(verdict(asking("a, b"), {days}),
               "**Does it pay? In part: better in Aville; not answered in Btown.** Passengers lost at equal kilometres "
               "driven empty (fewer is better), our planner against the rival: Aville −49.8 % (−52.2 to −47.2 %).\n\n");
  expect_begin(verdict(asking("b, c"), {days}), "**Does it pay? Not answered.**\n\n");
  add_city(days, "c", unclear);
  expect_begin(verdict(asking("b, c"), {days}), "**Does it pay? Not shown in c; not answered in Btown.** ");
}

TEST(Verdict, DependsOnAllPrimaryEndpointsOfThePage) {
  std::vector<FinishedDay> days;
  add_city(days, "a", {80.0, 84.0, 91.0});  // p = 0.04 by itself
  add_city(days, "b", unclear);
  expect_begin(verdict(asking("a"), {days}), "**Does it pay? Yes.** ");
  expect_begin(verdict(asking("a, b"), {days}), "**Does it pay? Not shown.** ");
}

TEST(Verdict, TellsHowMuchOfTheWayToTheBoundWasGone) {
  std::vector<FinishedDay> days;
  add_city(days, "a", fewer);
  add_city(days, "b", unclear);
  EXPECT_NE(verdict(asking("a, b"), {days}).find("No bound was computed, so that is not known.\n"), std::string::npos);
  std::vector<FinishedDay> bounds;
  for (int date = 0; date < 3; ++date) {
    bounds.push_back(asked_day("a", bound_variant, "", date, 0.0, 20.0));
  }
  const std::string text = verdict(asking("a, b"), {days, bounds});
  EXPECT_NE(
      text.find("**How far is the best from what could be? 62 % of the way in Aville.** All days added up, our planner "
                "saves that share of what the rival loses beyond the bound, below which no planner can be; the "
                "differences above count a quiet day as much as a busy one. No bound was computed for Btown.\n"),
      std::string::npos)
      << text;  // 50 of 80
}

/// The page of one question about two pairs: the new one in `cities`, and the old one in a.
Page asking_both_ways(const std::string& cities) {
  return read_page(YamlValue::parse("title: T\nsections: [{title: S}]\nverdict:\n  - question: Does any?\n    fronts:\n"
                                    "      - {variants: [new], against: [old], primary: {scenarios: [" +
                                        cities +
                                        "]}}\n"
                                        "      - {variants: [old], against: [new], primary: {scenario: a}}\n",
                                    "sweep.yaml"),
                   {{"old", "new"}, {"a", "b"}, {"calm"}});
}

TEST(Verdict, NamesThePairsIfThereAreSeveral) {
  const Page page = asking_both_ways("a");
  std::vector<FinishedDay> days;
  add_city(days, "a", fewer);
  expect_begin(verdict(page, {days}),
               "**Does any? Mixed: better with new; worse with old.** Passengers lost at equal kilometres driven empty "
               "(fewer is better), "
               "in a: new against old −49.8 % (−52.2 to −47.2 %) and old against new +");
}

TEST(Verdict, NamesPairsAndPlacesIfThereAreSeveralOfBoth) {
  const Page page = asking_both_ways("a, b");
  std::vector<FinishedDay> days;
  add_city(days, "a", fewer);
  add_city(days, "b", fewer);
  expect_begin(verdict(page, {days}),
               "**Does any? Mixed: better with new against old in a and new against old in b; worse with old against "
               "new in a.** ");
}

TEST(Verdict, TellsTheWayOfWhomeverItAskedAboutInEachPlace) {
  const Page page = read_page(
      YamlValue::parse("title: T\nsections: [{title: S}]\nverdict:\n"
                       "  - {question: Here, fronts: {variants: [new], against: [old], primary: {scenario: a}}}\n"
                       "  - {question: There, fronts: {variants: [other], against: [old], primary: {scenario: b}}}\n",
                       "sweep.yaml"),
      {{"old", "new", "other"}, {"a", "b"}, {"calm"}});
  std::vector<FinishedDay> days;
  std::vector<FinishedDay> bounds;
  for (const std::string city : {"a", "b"}) {
    add_city(days, city, fewer);
    for (int date = 0; date < 3; ++date) {
      days.push_back(asked_day(city, "other", "1", date, 15.0, 99.0));
      bounds.push_back(asked_day(city, bound_variant, "", date, 0.0, 20.0));
    }
  }
  const std::string text = verdict(page, {days, bounds});
  EXPECT_NE(
      text.find("be? 62 % of the way in a and 62 % in b.** All days added up, new saves that share of what old loses"),
      std::string::npos)
      << text;
}

TEST(Verdict, CountsAnEndpointOnceThatASectionNamesToo) {
  const Page page = read_page(
      YamlValue::parse("title: T\nverdict:\n"
                       "  - {question: Does it, fronts: {variants: [new], against: [old], primary: {scenario: a}}}\n"
                       "sections:\n"
                       "  - {title: S, fronts: {variants: [new], against: [old], primary: {scenario: a}}}\n",
                       "sweep.yaml"),
      {{"old", "new"}, {"a", "b"}, {"calm"}});
  std::vector<FinishedDay> days;
  add_city(days, "a", fewer);
  const auto answers = primary_answers(page, days);
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].section, "Does it");
  EXPECT_EQ(answers[0].p_holm, answers[0].row.p);
}

TEST(PrimaryAnswer, NeverHasAPOfNothing) {
  EXPECT_EQ(p_text(0.0495), "0.0495");
  EXPECT_EQ(p_text(0.0001), "0.0001");
  EXPECT_EQ(p_text(2e-6), "< 0.0001");
}

}  // namespace
}  // namespace evbal

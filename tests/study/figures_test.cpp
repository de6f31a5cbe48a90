#include "common/error.hpp"
#include "experiments/study/statistics/study_figures.hpp"
#include "tests/study/whole_page.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace evbal {
namespace {

const PageNames known = {{"old", "new", "set"}, {"a", "b"}, {"calm", "rough"}};

Page drawing(const std::string& figures) {
  return read_page(
      YamlValue::parse("title: T\nsections: [{title: S}]\nnames: {a: Aville, new: ours}\nfigures:\n" + figures,
                       "sweep.yaml"),
      known);
}

FinishedDay drawn_day(const std::string& scenario, const std::string& variant, double km, double lost,
                      const std::string& date) {
  FinishedDay day{.scenario = scenario, .variant = variant, .controller = "ratio", .faults = "calm", .day = date};
  day.seed = 1;
  day.settings = {{"price", std::to_string(km)}};
  day.totals = {{"idle_km", km}, {"lost", lost}, {"unfairness_demand", lost}, {"unfairness_charging", 3.0}};
  return day;
}

/// Two days of one city: `old` and `new` are fronts, `set` is one setting.
std::vector<FinishedDay> drawn_days() {
  std::vector<FinishedDay> days;
  for (const auto& [date, more] : {std::pair("d1", 0.0), std::pair("d2", 10.0)}) {
    for (const auto& [km, lost] : {std::pair(10.0, 120.0), std::pair(15.0, 130.0), std::pair(20.0, 80.0)}) {
      days.push_back(drawn_day("a", "old", km, lost + more, date));
      days.push_back(drawn_day("a", "new", km, lost / 2.0 + more, date));
    }
    days.push_back(drawn_day("a", "set", 15.0, 60.0 + more, date));
  }
  return days;
}

StudyFigure only_figure(const std::string& figures, const std::vector<FinishedDay>& bounds = {}) {
  const Page page = drawing(figures);
  const PageDays days{drawn_days(), bounds};
  return study_figures(page, days, primary_answers(page, days.days)).at(0);
}

TEST(StudyFigures, ShowFrontsWithTheirHullAndSettingsWithTheirIntervals) {
  const auto figure = only_figure("  - {fronts: {variants: [old, set], faults: calm, scenarios: [a]}, caption: C.}\n");
  EXPECT_EQ(figure.name, "1-fronts");
  ASSERT_EQ(figure.fronts.size(), 1U);
  const FrontPanel& panel = figure.fronts[0];
  EXPECT_EQ(panel.title, "Aville");
  EXPECT_EQ(panel.note, "No bound was computed.");
  ASSERT_EQ(panel.lines.size(), 2U);
  EXPECT_EQ(panel.lines[0].points.size(), 3U);
  EXPECT_EQ(panel.lines[0].hull.size(), 2U) << "130 at 15 km is bettered";
  EXPECT_DOUBLE_EQ(panel.lines[0].hull[0].value, 125.0);
  EXPECT_FALSE(panel.lines[0].km);
  EXPECT_DOUBLE_EQ(panel.lines[1].lost.value().mean, 65.0);
}

TEST(StudyFigures, DrawTheBoundOnlyIfEachDayHasOne) {
  const std::string fronts = "  - {fronts: {variants: [old], faults: calm, scenarios: [a]}, caption: C.}\n";
  const auto corner = [](const std::string& date, double lost) {
    return drawn_day("a", bound_variant, 5.0, lost, date);
  };
  const auto some = only_figure(fronts, {corner("d1", 10.0)});
  EXPECT_TRUE(some.fronts[0].bound.empty());
  EXPECT_EQ(some.fronts[0].note, "Bound of 1 of 2 days only: not drawn.");
  const auto all = only_figure(fronts, {corner("d1", 10.0), corner("d2", 30.0)});
  ASSERT_EQ(all.fronts[0].bound.size(), 1U);
  EXPECT_DOUBLE_EQ(all.fronts[0].bound[0].cost, 5.0);
  EXPECT_DOUBLE_EQ(all.fronts[0].bound[0].value, 20.0);
  EXPECT_EQ(all.fronts[0].note, "");
}

TEST(StudyFigures, ShowThePapersClaimsBesideOurs) {
  const auto figure = only_figure("  - {claims: {variant: new, against: old, faults: calm}, caption: C.}\n");
  ASSERT_EQ(figure.groups.size(), 3U);
  EXPECT_EQ(figure.groups[1].title, "Unfairness of supply to demand, at equal km driven empty");
  ASSERT_EQ(figure.groups[1].rows.size(), 3U) << "the paper's, and of each city";
  EXPECT_DOUBLE_EQ(figure.groups[0].rows[0].paper.value(), -0.1449);
  EXPECT_DOUBLE_EQ(figure.groups[2].rows[0].paper.value(), -0.3451);
  EXPECT_LT(figure.groups[1].rows[1].difference.value().mean, -0.4);
  EXPECT_FALSE(figure.groups[1].rows[2].difference) << "of b there is no day";
}

TEST(StudyFigures, ShowDaysCellsAndSwitches) {
  const auto slopes = only_figure("  - {slopes: {variant: new, against: old, faults: calm}, caption: C.}\n");
  ASSERT_EQ(slopes.slopes.at(0).days.size(), 2U);
  EXPECT_EQ(slopes.to, "ours");
  EXPECT_DOUBLE_EQ(slopes.slopes[0].days[1].reference, 110.0);
  EXPECT_DOUBLE_EQ(slopes.slopes[0].days[1].value, 60.0);
  const auto map = only_figure("  - {map: {variant: new, against: old}, caption: C.}\n");
  ASSERT_EQ(map.groups.size(), 2U);
  ASSERT_EQ(map.groups[0].rows.size(), 2U);
  EXPECT_TRUE(map.groups[0].rows[0].difference);
  EXPECT_FALSE(map.groups[0].rows[1].difference) << "no day with faults";
  const auto ablation =
      only_figure("  - {ablation: {variants: [new, set], against: [old], faults: calm}, caption: C.}\n");
  EXPECT_EQ(ablation.groups.at(0).rows.size(), 2U);
}

TEST(StudyFigures, ShowMetricsAsBars) {
  const auto figure = only_figure("  - {bars: {variants: [new, set], metrics: [lost, idle_km]}, caption: C.}\n");
  EXPECT_EQ(figure.title, "lost and idle_km, a day");
  ASSERT_EQ(figure.bars.size(), 1U) << "of b, and with faults, there is no day";
  EXPECT_EQ(figure.bars[0].title, "Aville, calm");
  ASSERT_EQ(figure.bars[0].bars.size(), 4U);
  EXPECT_EQ(figure.bars[0].bars[0].name, "ours, lost");
  EXPECT_DOUBLE_EQ(figure.bars[0].bars[2].value.mean, 65.0);
  EXPECT_TRUE(is_known(figure.bars[0].bars[2].value));
}

TEST(StudyFigures, ShowSharesOfAllDaysTogether) {
  const auto figure = only_figure(
      "  - {bars: {variants: [set], metrics: [lost], of: idle_km, scenarios: [a], faults: [calm]}, caption: C.}\n");
  EXPECT_EQ(figure.title, "lost, share of idle_km");
  EXPECT_TRUE(figure.shares);
  EXPECT_EQ(figure.bars.at(0).title, "calm");
  EXPECT_EQ(figure.bars[0].bars.at(0).name, "set");
  EXPECT_DOUBLE_EQ(figure.bars[0].bars[0].value.mean, 130.0 / 30.0);
  EXPECT_FALSE(is_known(figure.bars[0].bars[0].value));
}

TEST(StudyFigures, StandOnThePageBeforeItsTables) {
  const Page page =
      read_page(YamlValue::parse("title: T\ntext: Read so.\ndecided_after: |\n  One.\n\n  Two.\n"
                                 "verdict: [{question: Ask, fronts: {variants: [new], against: [old], primary: "
                                 "{scenario: a, faults: calm}}}]\n"
                                 "figures: [{forest: primaries, caption: Look.}]\nsections: [{title: S}]\n",
                                 "sweep.yaml"),
                known);
  const std::string text = whole_page(page, {drawn_days()}, "evbal sweep s.yaml");
  std::size_t at = 0;
  for (const char* part :
       {"# T\n\n**Ask ", "\n![The questions, and what came out](figures/1-forest.svg)\n", "\n**Figure 1.** Look.\n",
        "\n> **Decided after results were seen.** One.\n> \n> Two.\n", "\n## How to read it\n\nRead so.\n",
        "\n## Appendix: tables\n", "\n### Primary endpoints\n", "\n### S\n"}) {
    const std::size_t found = text.find(part, at);
    ASSERT_NE(found, std::string::npos) << part << "\nis not, or not in its place, in\n" << text;
    at = found;
  }
}

TEST(StudyFigures, AreReadStrictly) {
  const auto refuse = [](const std::string& page, const std::string& words) {
    try {
      read_page(YamlValue::parse("title: T\nsections: [{title: S}]\n" + page, "sweep.yaml"), known);
      FAIL() << words;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("sweep.yaml:4: "), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refuse("figures:\n- {fronts: {variants: [nwe], faults: calm}, caption: C}\n",
         "`nwe` is no variant (did you mean `new`?)");
  refuse("figures:\n- {fronts: {variants: [new]}, caption: C}\n", "say which `faults`");
  refuse("figures:\n- {caption: C}\n", "give one of `fronts`, `claims`");
  refuse("figures:\n- {forest: primaries, map: {variant: new, against: old}, caption: C}\n", "shows one thing");
  refuse("figures:\n- {forest: all, caption: C}\n", "`primaries`");
  refuse("figures:\n- {forest: primaries}\n", "`caption`");
  refuse("figures:\n- {slopes: {variants: [new], against: old, faults: calm}, caption: C}\n", "`variant`");
  refuse("names:\n  nwe: ours\n", "no variant, scenario or schedule of faults (did you mean `new`?)");
  refuse("verdict:\n- {question: Q, fronts: {variants: [new], against: [old]}}\n", "`primary: {scenarios: [...]}`");
  refuse(
      "verdict:\n- {question: Q, fronts: {variants: [new], against: [old], metrics: [served], primary: {scenario: a, "
      "faults: calm}}}\n",
      "a verdict is on `lost` or `idle_km`");
  refuse("verdict:\n- {question: Q, fronts: {variants: [new], against: [old], primary: {faults: calm}}}\n",
         "say which scenario");
}

}  // namespace
}  // namespace evbal

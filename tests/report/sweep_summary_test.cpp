#include "tools/report/sweep_summary.hpp"

#include "common/error.hpp"
#include "tools/report/report.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

FinishedDay swept(const std::string& variant, const std::string& price, const std::string& day, std::uint64_t seed,
                  double idle_km, double lost) {
  FinishedDay made{.variant = variant, .controller = variant, .faults = "calm", .day = day, .seed = seed};
  made.settings = {{"balancing.p_shortage", price}};
  for (const auto& metric : metric_names()) {
    made.totals[metric] = 1.0;
  }
  made.totals["idle_km"] = idle_km;
  made.totals["lost"] = lost;
  return made;
}

/// Two seeds on the first day, one on the second; `turnover` at two prices.
std::vector<FinishedDay> small_sweep() {
  return {swept("ratio", "", "2024-01-11", 1, 10.0, 4.0),      swept("ratio", "", "2024-01-11", 2, 10.0, 4.0),
          swept("ratio", "", "2024-01-12", 1, 10.0, 4.0),      swept("turnover", "12", "2024-01-11", 1, 8.0, 2.0),
          swept("turnover", "12", "2024-01-11", 2, 8.0, 4.0),  swept("turnover", "12", "2024-01-12", 1, 8.0, 5.0),
          swept("turnover", "24", "2024-01-11", 1, 12.0, 2.0), swept("turnover", "24", "2024-01-11", 2, 12.0, 2.0),
          swept("turnover", "24", "2024-01-12", 1, 12.0, 2.0)};
}

std::vector<FinishedSteps> small_steps() {
  std::vector<FinishedSteps> steps(9, {{"05:00", "05:30", "06:00"}, {{"lost", {1.0, 2.0, 4.0}}}});
  steps[5].columns["lost"] = {2.0, 3.0, 4.0};
  return steps;
}

TEST(SweepSummary, TakesMeansOverDaysOfTheirSeeds) {
  const auto points = swept_points(small_sweep(), small_steps());
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1].first.settings.at("balancing.p_shortage"), "12");
  EXPECT_EQ(points[1].pairs, 3);
  EXPECT_EQ(points[1].means.at("lost"), 4.0);  // of 3 and 5
  const auto& hours = points[1].hours.at("lost");
  ASSERT_EQ(hours.size(), 2U);
  EXPECT_EQ(hours[0].hour, 5);
  EXPECT_EQ(hours[0].interval.mean, 4.0);  // of 3 and 5
  EXPECT_GT(hours[0].interval.high, 5.0);
  EXPECT_EQ(hours[1].interval.mean, 4.0);
}

const Answer& answer_to(const std::vector<Answer>& all, const std::string& metric) {
  return *std::find_if(all.begin(), all.end(), [&](const Answer& one) { return one.question.metric == metric; });
}

TEST(SweepSummary, AsksAtEqualCostWhereTheReferenceHasAFront) {
  const auto plain = answers(small_sweep(), {"ratio"}, {});
  EXPECT_EQ(answer_to(plain, "lost").question.at, std::nullopt);
  ASSERT_EQ(answer_to(plain, "lost").rows.size(), 2U);
  const auto front = answers(small_sweep(), {"turnover"}, {});
  EXPECT_EQ(answer_to(front, "lost").question.at, "idle_km");
  EXPECT_EQ(answer_to(front, "idle_km").question.at, "lost");
  ASSERT_EQ(answer_to(front, "lost").rows.size(), 1U);
  EXPECT_DOUBLE_EQ(answer_to(front, "lost").rows[0].reference, 5.0 + 3.5);  // midway, both seeds of the first day
  EXPECT_THROW(answers(small_sweep(), {"robust"}, {}), Error);
}

TEST(SweepSummary, StandsOnThePage) {
  const SweepContent sweep{.folder = "runs/small",
                           .origin = {"evbal sweep small.yaml", "small.yaml", "schema: 1\n", ""},
                           .page = {{.verdict = "**Small?** Yes.\n"}},
                           .days = 9,
                           .points = swept_points(small_sweep(), small_steps()),
                           .answers = answers(small_sweep(), {"ratio"}, {})};
  const std::string page = report_page({.title = "small", .sweep = sweep});
  EXPECT_NE(
      page.find("\"sweep\":{\"folder\":\"runs/small\",\"command\":\"evbal sweep small.yaml\",\"file\":\"small.yaml\""),
      std::string::npos);
  EXPECT_NE(page.find("\"hours\":{\"lost\":[[5,3.0,null,null],[6,4.0,null,null]]}"), std::string::npos);
}

}  // namespace
}  // namespace evbal

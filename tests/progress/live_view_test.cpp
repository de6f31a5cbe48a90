#include "experiments/progress/live_view.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

namespace evbal {
namespace {

const DayClock clock_of_a_day;

DayState some_day(std::size_t regions) {
  DayState day;
  day.ticks = 42;
  day.served = 300;
  day.lost = 100;
  day.demand.assign(regions, 4);
  day.vacant.assign(regions, 8);
  day.queue.assign(regions, 0);
  day.waiting.assign(regions, 1);
  day.faults = {"hub-outage-1"};
  day.planned_at = 200;
  day.provenance.controller = "robust";
  day.provenance.engine = "cuts";
  day.provenance.iterations = 3;
  return day;
}

/// Characters of a line in UTF-8.
long characters(const std::string& line) {
  return std::count_if(line.begin(), line.end(), [](char byte) { return (byte & 0xC0) != 0x80; });
}

std::string all(const std::vector<std::string>& lines) {
  return std::accumulate(lines.begin(), lines.end(), std::string(),
                         [](const std::string& text, const std::string& line) { return text + line + "\n"; });
}

TEST(LiveView, ShowsClockPassengersBarsFaultsAndPlan) {
  DayState day = some_day(3);
  day.queue[1] = 5;
  const std::string view = all(live_view("robust", clock_of_a_day, day, 75.0, 79));
  EXPECT_NE(view.find("robust  08:30  "), std::string::npos) << view;
  EXPECT_NE(view.find("1 min 15 s left"), std::string::npos) << view;
  EXPECT_NE(view.find("served 300  lost 100 (25.0 %)  waiting 3  vacant 24  queue 5"), std::string::npos) << view;
  EXPECT_NE(view.find("demand  ▄▄▄\n"), std::string::npos) << view;
  EXPECT_NE(view.find("vacant  ███\n"), std::string::npos) << view;
  EXPECT_NE(view.find("queue    █ \n"), std::string::npos) << view;
  EXPECT_NE(view.find("[hub-outage-1]"), std::string::npos) << view;
  EXPECT_NE(view.find("plan    08:20 robust by cuts, 3 iterations"), std::string::npos) << view;
}

TEST(LiveView, SaysHowAPlanFellBackAndWhomItDidNotBelieve) {
  DayState day = some_day(3);
  day.provenance.fallback = FallbackLevel::hold;
  day.provenance.reason = "solver failed";
  day.provenance.rejected = {{1, "vacant -3"}};
  const std::string view = all(live_view("robust", clock_of_a_day, day, 0.0, 200));
  EXPECT_NE(view.find("; fell back, nobody moves: solver failed; 1 reports not believed"), std::string::npos) << view;
}

TEST(LiveView, BeforeTheFirstPlanThereIsNone) {
  EXPECT_EQ(live_view("none", clock_of_a_day, DayState{.ticks = 1}, 0.0, 40).back(), "plan    ");
}

RC_GTEST_PROP(LiveView, EveryLineFitsAndKeepsItsPlace, ()) {
  const auto regions = *rc::gen::inRange<std::size_t>(1, 600);
  const int columns = *rc::gen::inRange(20, 200);
  DayState day = some_day(regions);
  day.faults.assign(*rc::gen::inRange<std::size_t>(0, 20), "a-fault");
  const auto lines = live_view("turnover", clock_of_a_day, day, 4000.0, columns);
  RC_ASSERT(lines.size() == live_view("turnover", clock_of_a_day, {.ticks = 1}, 0.0, columns).size());
  for (const auto& line : lines) {
    RC_ASSERT(characters(line) <= columns);
  }
}

}  // namespace
}  // namespace evbal

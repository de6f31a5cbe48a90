#include "faults/schedule/schedule.hpp"

#include "tests/faults/schedule_fixture.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <cassert>
#include <fstream>
#include <set>

namespace evbal {
namespace {

using testing::outage;
using testing::read_runs;
using testing::read_text;
using testing::replaced;
using testing::schedule_of;
using testing::small_context;
using testing::spike;

TEST(Schedule, ReadsWhatIsWritten) {
  const auto schedule = read_text(schedule_of({spike + ", ramp: 15min, visible: false", outage + ", on_start: evict"},
                                              "guard: {max_active: 2, min_working_points: 3, overlap: reject}, "));
  EXPECT_EQ(schedule.seed, 7U);
  EXPECT_EQ(schedule.guard, (Guard{2, 3}));
  ASSERT_EQ(schedule.faults.size(), 2U);
  EXPECT_EQ(schedule.faults[0], (Fault{.name = "spike",
                                       .type = EffectType::demand_scale,
                                       .regions = {0, 2},
                                       .magnitudes = {1.8, 1.8},
                                       .start = 12 * 60 + 30,
                                       .duration = 90,
                                       .ramp = 15,
                                       .visible = false}));
  EXPECT_EQ(schedule.faults[1], (Fault{.name = "outage",
                                       .type = EffectType::charger_outage,
                                       .regions = {1},
                                       .magnitudes = {2},
                                       .start = 150,
                                       .duration = 120,
                                       .on_start = OnStart::evict}));
}

TEST(Schedule, PicksAmongTheRegionsThatFit) {
  const std::string head = "{name: hub, type: charger.outage, start: \"08:00\", duration: 1h, ";
  const auto two =
      read_text(schedule_of({head + "target: {pick: 2, of: {min_points: 10}}, magnitude: {fraction_of_points: 1}"}));
  EXPECT_EQ(two.faults.at(0).regions, (std::vector<int>{3, 4}));
  EXPECT_EQ(two.faults.at(0).magnitudes, (std::vector<double>{12, 20}));
  const auto any = read_text(schedule_of({head + "target: {pick: 3}, magnitude: {points: 4}"}));
  EXPECT_EQ(any.faults.at(0).regions, (std::vector<int>{1, 3, 4}));
  EXPECT_EQ(any.faults.at(0).magnitudes, (std::vector<double>{4, 4, 4}));
  const auto one = read_text(
      schedule_of({head + "target: {pick: 1, of: {regions: [4]}}, magnitude: {points: {uniform: {min: 5, max: 6}}}"}));
  EXPECT_EQ(one.faults.at(0).regions, (std::vector<int>{4}));
}

TEST(Schedule, RepeatsWithinTheArrivalsWindow) {
  const auto schedule =
      read_text(schedule_of({"{name: blink, type: demand.scale, target: {pick: 1}, magnitude: 2, duration: 1min, "
                             "arrivals: {poisson: {per_hour: 3, from: \"07:00\", to: \"22:00\"}}"}));
  ASSERT_GT(schedule.faults.size(), 20U);  // 45 expected
  ASSERT_LT(schedule.faults.size(), 75U);
  EXPECT_EQ(schedule.faults[0].name, "blink-1");
  for (const auto& fault : schedule.faults) {
    EXPECT_GE(fault.start, 120);
    EXPECT_LT(fault.start, 17 * 60);
  }
}

TEST(Schedule, DrawsOfAFaultDependOnItsOwnNameOnly) {
  const std::string open =
      "{name: b, type: demand.scale, target: {pick: 2}, start: {uniform: {min: \"06:00\", max: \"20:00\"}}, "
      "duration: {lognormal: {median: 40min, sigma: 0.6}}, magnitude: {normal: {mean: 1.8, sd: 0.2, min: 1}}";
  const auto alone = read_text(schedule_of({open}));
  const auto after = read_text(schedule_of({outage, open}));
  EXPECT_EQ(alone.faults.at(0), after.faults.at(1));
}

TEST(Schedule, TakesAShareOfTheRegionsThatFit) {
  const auto regions = [](const std::string& target) {
    return read_text(schedule_of({replaced(spike, "{regions: [2, 0]}", target)})).faults.at(0).regions;
  };
  EXPECT_EQ(regions("{fraction: 0.6}").size(), 3U);
  EXPECT_EQ(regions("{fraction: 0.01}").size(), 1U) << "at least one";
  EXPECT_EQ(regions("{fraction: 1, of: {min_points: 1}}"), (std::vector<int>{1, 3, 4}));
  EXPECT_EQ(regions("{fraction: 0.5, of: {regions: [1, 2, 3, 4]}}").size(), 2U);
}

TEST(Schedule, IsDrawnAsOftenAsAsked) {
  const std::string open = replaced(spike, "{regions: [2, 0]}", "{pick: 2}");
  const auto runs = read_runs(schedule_of({open}, "runs: 30, "));
  ASSERT_EQ(runs.size(), 30U);
  EXPECT_EQ(runs[0], read_text(schedule_of({open}))) << "the first is what is drawn alone";
  std::set<std::vector<int>> drawn;
  for (const auto& run : runs) {
    drawn.insert(run.faults.at(0).regions);
  }
  EXPECT_GT(drawn.size(), 5U);
  EXPECT_EQ(read_runs(schedule_of({open}, "runs: 40, "))[29], runs[29]) << "more runs change none";
}

/// The indented block under a heading of docs/faults.md.
std::string example_under(const std::string& heading) {
  std::ifstream page(test::in_source("docs/faults.md"));
  std::string line;
  while (std::getline(page, line) && line != heading) {
  }
  std::string block;
  while (std::getline(page, line) && !line.starts_with("## ")) {
    block += line.starts_with("    ") ? line.substr(4) + "\n" : "";
  }
  return block;
}

TEST(Schedule, TakesTheExamplesOfItsPage) {
  const FaultContext context{DayClock{}, std::vector<int>(13, 6)};
  YamlMap request(YamlValue::parse(example_under("## An example"), "faults.md"));
  const auto drawn = read_schedules(request, context).front();
  EXPECT_EQ(drawn.faults.at(0).name, "evening-spike");
  EXPECT_EQ(drawn.faults.at(1).name, "hub-outage-1");
  EXPECT_TRUE(request.find("expect"));
  EXPECT_NO_THROW(request.finish());
  YamlMap resolved(YamlValue::parse(example_under("## The resolved schedule"), "faults.md"));
  EXPECT_EQ(read_resolved(resolved, context).faults.at(0).magnitudes, (std::vector<double>{4, 6}));
}

}  // namespace
}  // namespace evbal

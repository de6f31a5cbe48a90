// A day that is asked for something while it goes on.

#include "common/files.hpp"
#include "experiments/record/compare.hpp"
#include "experiments/record/recorded_fault.hpp"
#include "experiments/run/record_day.hpp"
#include "tests/folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <map>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Three hours of the toy city.
Scenario morning(const std::string& controller = "nominal") {
  return read_scenario(test::in_source("experiments/scenarios/toy.yaml"),
                       {.controller = controller,
                        .transport = "inproc",
                        .settings = {"clock={start: \"07:00\", end: \"10:00\", tick: 5min, step: 30min, plan_every: "
                                     "10min}",
                                     "faults={schema: 1, guard: {max_active: 2}, faults: []}"}});
}

class DayDoorTest : public ::testing::Test {
 protected:
  /// Plays the day; after the tick of the number the request is made. Their answers are in `answers_`.
  RunResult play(const Scenario& scenario, const std::map<int, std::string>& requests, DoorOptions options = {}) {
    std::map<int, fs::path> files;
    const auto keep_answers = [&] {
      for (const auto& [tick, file] : files) {
        if (const auto said = text_of_file(fs::path(file).replace_extension(".answer")); !said.empty()) {
          answers_[tick] = said;
        }
      }
    };
    const auto on_tick = [&](const TickRecord& record) {
      keep_answers();
      ticks_.push_back(record);
      if (const auto request = requests.find(record.tick.tick); request != requests.end()) {
        const fs::path file = run() / "requests" / (std::to_string(record.tick.tick) + ".request");
        write_file(file, request->second);
        files[record.tick.tick] = file;
      }
    };
    return record_day(scenario, resolved_yaml(scenario, scenario.planning.controller), run(),
                      {.transport = "inproc", .on_tick = on_tick, .door = std::move(options)});
  }

  fs::path run() const { return folder_.path() / "run"; }

  /// Ticks in which the fault of that position acts.
  std::vector<int> acts(int fault) const {
    std::vector<int> found;
    for (const auto& record : ticks_) {
      for (const Effect& effect : record.tick.effects) {
        if (effect.fault == fault) {
          found.push_back(record.tick.tick);
          break;
        }
      }
    }
    return found;
  }

  Folder folder_;
  std::vector<TickRecord> ticks_;
  std::map<int, std::string> answers_;
};

const std::string close_region_0 =
    "{do: fault, fault: {type: charger.outage, target: {regions: [0]}, duration: 15min, "
    "magnitude: {fraction_of_points: 1}, on_start: evict}}";

TEST_F(DayDoorTest, AddsAFaultAtTheNextTickAndTheReplayIsTheSame) {
  const RunResult result =
      play(morning(), {{4, close_region_0},
                       {9,
                        "{do: fault, fault: {name: spike, type: demand.scale, target: {pick: 2}, duration: 20min, "
                        "magnitude: {uniform: {min: 2, max: 4}}}}"}});
  EXPECT_EQ(acts(0), (std::vector<int>{5, 6, 7}));
  EXPECT_EQ(acts(1), (std::vector<int>{10, 11, 12, 13}));
  EXPECT_EQ(answers_[4], "yes\nfault `by-hand-1` begins at 07:25");
  const auto faults = read_faults(run() / "run.sqlite");
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].name, "by-hand-1");
  EXPECT_EQ(faults[0].start, 25);
  EXPECT_FALSE(faults[0].amount.empty()) << "it was seen to act";

  const Scenario again = read_scenario(run() / "scenario.resolved.yaml");
  EXPECT_EQ(again.schedule.faults.size(), 2U);
  const fs::path replayed = folder_.path() / "again";
  const RunResult replay =
      record_day(again, text_of_file(run() / "scenario.resolved.yaml"), replayed, {.transport = "inproc"});
  EXPECT_EQ(replay.digest, result.digest);
  EXPECT_EQ(first_difference(run(), replayed, again.world.clock), std::nullopt);
}

TEST_F(DayDoorTest, LeavesTheFaultsAsAScheduleForOtherDays) {
  play(morning(), {{4, close_region_0}});
  const Scenario other = read_scenario(test::in_source("experiments/scenarios/toy.yaml"),
                                       {.day = "2024-01-12", .faults = run() / "faults.yaml"});
  Schedule played = read_scenario(run() / "scenario.resolved.yaml").schedule;
  ASSERT_EQ(played.faults.size(), 1U);
  EXPECT_EQ(played.faults[0].start, 25);
  played.faults[0].start += 120;  // the other day begins two hours earlier
  EXPECT_EQ(other.schedule, played);
}

TEST_F(DayDoorTest, RefusesWhatAScheduleMayNotHave) {
  play(morning(), {{1, close_region_0},
                   {2, close_region_0},
                   {3, "{do: fault, fault: {type: charger.otage}}"},
                   {4, "{do: dance}"},
                   {5, "[1, 2"},
                   {6, std::string(longest_request + 1, ' ')},
                   {7, "{do: kill, process: agent-1}"},
                   {8, "{do: pause, now: true}"}});
  EXPECT_TRUE(answers_[1].starts_with("yes\n")) << answers_[1];
  for (const int tick : {2, 3, 4, 5, 6, 7, 8}) {
    EXPECT_TRUE(answers_[tick].starts_with("no\n")) << tick << answers_[tick];
  }
  EXPECT_NE(answers_[2].find("overlaps `by-hand-1`"), std::string::npos) << answers_[2];
  EXPECT_NE(answers_[3].find("did you mean `charger.outage`?"), std::string::npos) << answers_[3];
  EXPECT_EQ(read_faults(run() / "run.sqlite").size(), 1U);
}

TEST_F(DayDoorTest, TellsThoseWhoForesawTheDayNothingNew) {
  play(morning("oracle"), {{4, close_region_0}});
  EXPECT_NE(answers_[4].find("was told the day's faults before it began"), std::string::npos) << answers_[4];
}

TEST_F(DayDoorTest, StandsStillUntilItMayGoOn) {
  std::set<int> paused_before;
  std::vector<std::thread> others;
  const auto on_pace = [&](const DayPace& pace) {
    if (pace.paused && paused_before.insert(pace.tick).second) {
      const std::string next = paused_before.size() == 1 ? "{do: tick}" : "{do: go on}";
      others.emplace_back([this, next] { ask_run(run(), next, std::chrono::seconds(60)); });
    }
  };
  play(morning(), {{4, "{do: pause}"}}, {.on_pace = on_pace});
  for (std::thread& other : others) {
    other.join();
  }
  EXPECT_EQ(ticks_.size(), 36U);
  EXPECT_EQ(paused_before, (std::set<int>{5, 6})) << "one tick, then paused again";
}

TEST_F(DayDoorTest, GoesNoFasterThanItsPace) {
  const auto begin = std::chrono::steady_clock::now();
  play(morning(), {{3, "{do: speed, speed: unlimited}"}}, {.speed = 3000.0});
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(300)) << "four ticks of 0.1 s at least";
}

TEST_F(DayDoorTest, IsClosedWhereNoRunGoesOn) {
  EXPECT_THROW(ask_run(folder_.path(), "{do: pause}", std::chrono::seconds(1)), Error);
  fs::create_directories(run() / "requests");  // of a run that broke off
  EXPECT_THROW(ask_run(run(), "{do: pause}", std::chrono::seconds(1)), Error);
}

}  // namespace
}  // namespace evbal

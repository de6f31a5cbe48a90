#include "tests/run/evbal/command_line.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;

const std::string small = EVBAL_SOURCE_DIR "/experiments/studies/sweep-small.yaml";

long lines_of(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

/// Days of a sweep that have their results, 0 while there is no sweep.
int finished(const fs::path& folder) {
  try {
    const SQLite::Database database((folder / "sweep.sqlite").string(), SQLite::OPEN_READONLY, 1000);
    SQLite::Statement count(database, "SELECT count(*) FROM results");
    return count.executeStep() ? count.getColumn(0).getInt() : 0;
  } catch (const SQLite::Exception&) {
    return 0;
  }
}

TEST(Sweep, GoesOnAfterAKillAndGivesTheSameBytesForAnyNumberOfJobs) {
  const CommandLine line;
  const pid_t id = line.start("sweep " + small + " --jobs 2 --out killed");
  for (int i = 0; i < 3000 && finished(line.path() / "killed") < 2; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  kill(id, SIGKILL);
  wait_for(id);
  const int before = finished(line.path() / "killed");
  ASSERT_GE(before, 2);
  ASSERT_LT(before, 12);
  EXPECT_FALSE(fs::exists(line.path() / "killed" / "days.csv"));

  const Ended resumed = line.evbal("sweep " + small + " --jobs 2 --out killed");
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(resumed.out, "killed/days.csv\n");
  EXPECT_EQ(lines_of(resumed.err), 12 - before) << resumed.err;
  const Ended whole = line.evbal("sweep " + small + " --jobs 1 --out whole --quiet");
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_EQ(whole.err, "");
  const std::string days = text_of(line.path() / "whole" / "days.csv");
  EXPECT_EQ(lines_of(days), 13) << days;
  EXPECT_TRUE(text_of(line.path() / "killed" / "days.csv") == days);
  EXPECT_TRUE(text_of(line.path() / "killed" / "steps.csv") == text_of(line.path() / "whole" / "steps.csv"));

  const Ended compared = line.evbal("compare whole --against ratio");
  EXPECT_EQ(compared.status, 0) << compared.err;
  EXPECT_NE(compared.out.find("turnover  balancing.p_shortage=24 "), std::string::npos) << compared.out;
  EXPECT_EQ(lines_of(compared.out), 4) << compared.out;
  EXPECT_EQ(line.evbal("compare whole --against robust").status, 2);
}

const std::string tuning =
    "schema: 1\nscenario: morning.yaml\nseeds: [7]\nobjective: {idle_km: 1, lost: 20}\ncandidates: 3\n"
    "variants:\n"
    "  - {controller: ratio, settings: {engine: cuts}, search: {balancing.p_ratio: {from: 5, to: 80}}}\n"
    "  - {controller: none, search: {balancing.tau: [1, 2]}}\n";

TEST(Tune, GivesTheSameBytesForAnyNumberOfJobsAndASweepTakesThem) {
  const CommandLine line;
  std::ofstream(line.path() / "tuning.yaml") << tuning << "days: [2024-01-03, 2024-01-02, 2024-01-01]\n";
  const Ended two = line.evbal("tune tuning.yaml --jobs 2 --out two --quiet");
  ASSERT_EQ(two.status, 0) << two.err;
  EXPECT_EQ(two.out, "two/tuned.yaml\n");
  ASSERT_EQ(line.evbal("tune tuning.yaml --jobs 1 --out one --quiet").status, 0);
  EXPECT_EQ(text_of(line.path() / "one" / "tuned.yaml"), text_of(line.path() / "two" / "tuned.yaml"));
  EXPECT_EQ(text_of(line.path() / "one" / "trials.csv"), text_of(line.path() / "two" / "trials.csv"));
  EXPECT_EQ(lines_of(text_of(line.path() / "one" / "trials.csv")), 7);

  std::ofstream(line.path() / "sweep.yaml") << "schema: 1\nscenario: morning.yaml\nseeds: [1]\ndays: [2024-01-11]\n"
                                               "tuning: tuning.yaml\nvariants: [{tuned: ratio}, {controller: none}]\n";
  const Ended swept = line.evbal("sweep sweep.yaml --out one --quiet");
  ASSERT_EQ(swept.status, 0) << swept.err;
  EXPECT_EQ(lines_of(text_of(line.path() / "one" / "days.csv")), 3);
  const Ended again = line.evbal("sweep sweep.yaml --out one");
  EXPECT_EQ(again.err, "");  // nothing is played twice
}

TEST(Tune, RefusesTestDays) {
  const CommandLine line;
  std::ofstream(line.path() / "tuning.yaml") << tuning << "days: [2024-01-03, 2024-01-11]\n";
  const Ended refused = line.evbal("tune tuning.yaml");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("`2024-01-11` is no training day"), std::string::npos) << refused.err;
  EXPECT_FALSE(fs::exists(line.path() / "runs"));
}

TEST(Sweep, RefusesWhatIsWrongBeforeAnyWork) {
  const CommandLine line;
  std::ofstream(line.path() / "bad.yaml")
      << "schema: 1\nscenario: morning.yaml\ndays: [2024-01-11]\nseeds: [1]\nvariants: [{controller: robst}]\n";
  const Ended bad = line.evbal("sweep bad.yaml");
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("bad.yaml:5: `robst` is not known"), std::string::npos) << bad.err;
  EXPECT_FALSE(fs::exists(line.path() / "runs"));
  EXPECT_EQ(line.evbal("sweep bad.yaml --jobs 0").status, 2);
  fs::create_directory(line.path() / "mine");
  std::ofstream(line.path() / "mine" / "letter.txt") << "dear";
  const Ended used = line.evbal("sweep " + small + " --out mine");
  EXPECT_EQ(used.status, 2);
  EXPECT_NE(used.err.find("holds no sweep"), std::string::npos) << used.err;
}

}  // namespace
}  // namespace evbal

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

/// Days of a sweep, or of the tuning in this file, that have their results, 0 while there is no such file.
int finished(const fs::path& folder, const std::string& file = "sweep.sqlite") {
  try {
    const SQLite::Database database((folder / file).string(), SQLite::OPEN_READONLY, 1000);
    SQLite::Statement count(database, "SELECT count(*) FROM results");
    return count.executeStep() ? count.getColumn(0).getInt() : 0;
  } catch (const SQLite::Exception&) {
    return 0;
  }
}

TEST(Sweep, SaysWhichDaysComeOutOtherwiseWhenPlayedAgain) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("sweep " + small + " --quick --out played --quiet").status, 0);
  {
    SQLite::Database database((line.path() / "played" / "sweep.sqlite").string(), SQLite::OPEN_READWRITE, 1000);
    database.exec("UPDATE results SET digest = 'another' WHERE key = (SELECT key FROM days WHERE run = 2)");
  }
  const Ended again = line.evbal("sweep " + small + " --quick --out played --replay 1000 --quiet");
  EXPECT_EQ(again.status, 1) << again.err;
  EXPECT_NE(again.err.find("days that came out otherwise:\n"), std::string::npos) << again.err;
  EXPECT_NE(again.err.find(", not another"), std::string::npos) << again.err;
  EXPECT_EQ(lines_of(again.err), 2) << again.err;
  const Ended whole = line.evbal("sweep " + small + " --out played --replay 1 --quiet");
  EXPECT_EQ(whole.status, 2) << whole.err;
  EXPECT_NE(whole.err.find("holds other days than the sweep has now"), std::string::npos) << whole.err;
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
  const Ended compared_before = line.evbal("compare killed --against ratio");
  EXPECT_NE(compared_before.err.find("evbal: " + std::to_string(before) + " of 12 days are played"), std::string::npos)
      << compared_before.err;
  const Ended plan = line.evbal("sweep " + small + " --out killed --jobs 2 --dry-run");
  EXPECT_EQ(plan.status, 0) << plan.err;
  EXPECT_NE(plan.out.find("12 days, " + std::to_string(12 - before) + " left; with 2 at a time: "), std::string::npos)
      << plan.out;
  EXPECT_EQ(finished(line.path() / "killed"), before);

  const Ended resumed = line.evbal("sweep " + small + " --jobs 2 --out killed");
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(resumed.out, "killed/days.csv\n");
  EXPECT_EQ(lines_of(resumed.err), 12 - before) << resumed.err;
  const Ended whole = line.evbal("sweep " + small + " --jobs 1 --out whole --quiet");
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_EQ(whole.err, "");
  const Ended replayed = line.evbal("sweep " + small + " --out whole --replay 5 --seed 3 --quiet");
  EXPECT_EQ(replayed.status, 0) << replayed.err;
  EXPECT_NE(replayed.out.find("played again 5 of 12 days, chosen by seed 3: the same digests"), std::string::npos)
      << replayed.out;
  const std::string days = text_of(line.path() / "whole" / "days.csv");
  EXPECT_EQ(lines_of(days), 13) << days;
  EXPECT_TRUE(text_of(line.path() / "killed" / "days.csv") == days);
  EXPECT_TRUE(text_of(line.path() / "killed" / "steps.csv") == text_of(line.path() / "whole" / "steps.csv"));

  const Ended compared = line.evbal("compare whole --against ratio");
  EXPECT_EQ(compared.status, 0) << compared.err;
  EXPECT_NE(compared.out.find("turnover  balancing.p_shortage=24 "), std::string::npos) << compared.out;
  EXPECT_EQ(lines_of(compared.out), 3) << compared.out;
  EXPECT_EQ(lines_of(line.evbal("compare whole --against ratio --csv").out), 3);
  const std::string one_day = line.evbal("compare whole --against ratio --days 2024-01-11 --csv").out;
  EXPECT_EQ(lines_of(one_day), 3) << one_day;
  EXPECT_NE(one_day, line.evbal("compare whole --against ratio --csv").out);
  EXPECT_EQ(lines_of(line.evbal("compare whole --against ratio --variant ratio --csv").out), 1) << "but for the head";
  const Ended unknown = line.evbal("compare whole --against ratio --days 2024-01-31");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("there is `2024-01-11`, `2024-01-12`"), std::string::npos) << unknown.err;
  const std::string part = line.evbal("sweep " + small + " --out whole --dry-run --variant ratio").out;
  EXPECT_NE(part.find("4 days, 0 left"), std::string::npos) << part;
  EXPECT_EQ(line.evbal("sweep " + small + " --out whole --variant ratio").status, 2) << "plays all of them or none";
  EXPECT_EQ(line.evbal("sweep " + small + " --out new --dry-run").status, 0);
  EXPECT_FALSE(fs::exists(line.path() / "new")) << "nothing is played, and nothing is left behind";
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
  EXPECT_EQ(text_of(line.path() / "one" / "candidates.csv"), text_of(line.path() / "two" / "candidates.csv"));
  EXPECT_EQ(lines_of(text_of(line.path() / "one" / "candidates.csv")), 1 + 4 + 2) << "the list has two values";
  EXPECT_NE(text_of(line.path() / "one" / "tuned.yaml").find("search: {tried: 4, days: "), std::string::npos);

  std::ofstream(line.path() / "sweep.yaml") << "schema: 1\nscenario: morning.yaml\nseeds: [1]\ndays: [2024-01-11]\n"
                                               "tuning: tuning.yaml\nvariants: [{tuned: ratio}, {controller: none}]\n";
  EXPECT_NE(line.evbal("sweep sweep.yaml --out three --dry-run").out.find("tunes its variants first"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(line.path() / "three"));
  const Ended swept = line.evbal("sweep sweep.yaml --out one --quiet");
  ASSERT_EQ(swept.status, 0) << swept.err;
  EXPECT_EQ(lines_of(text_of(line.path() / "one" / "days.csv")), 3);
  const Ended again = line.evbal("sweep sweep.yaml --out one");
  EXPECT_EQ(lines_of(again.err), 3) << "what was tuned, and no day that is played twice: " << again.err;
  const std::string plan = line.evbal("sweep sweep.yaml --out one --dry-run").out;
  EXPECT_NE(plan.find("2 days, 0 left"), std::string::npos) << plan;
}

TEST(Tune, GoesOnAfterAKillAndGivesTheSameBytes) {
  const CommandLine line;
  std::ofstream(line.path() / "tuning.yaml") << tuning << "days: [2024-01-03, 2024-01-02, 2024-01-01]\n";
  const Ended whole = line.evbal("tune tuning.yaml --jobs 2 --out whole");
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_NE(whole.err.find("regret at most"), std::string::npos) << whole.err;
  const int all = finished(line.path() / "whole", "tuning.sqlite");
  for (const int after : {1, all - 2}) {
    const std::string out = "killed-" + std::to_string(after);
    const pid_t id = line.start("tune tuning.yaml --jobs 1 --quiet --out " + out);
    for (int i = 0; i < 3000 && finished(line.path() / out, "tuning.sqlite") < after; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    kill(id, SIGKILL);
    wait_for(id);
    ASSERT_EQ(line.evbal("tune tuning.yaml --jobs 2 --quiet --out " + out).status, 0);
    for (const std::string file : {"tuned.yaml", "candidates.csv"}) {
      EXPECT_EQ(text_of(line.path() / out / file), text_of(line.path() / "whole" / file)) << out;
    }
    EXPECT_EQ(finished(line.path() / out, "tuning.sqlite"), all);
  }
}

TEST(Tune, LeavesASweepInItsFolderItsOwnDays) {
  const CommandLine line;
  std::ofstream(line.path() / "tuning.yaml") << tuning << "days: [2024-01-03, 2024-01-02]\n";
  std::ofstream(line.path() / "sweep.yaml") << "schema: 1\nscenario: morning.yaml\nseeds: [1]\ndays: [2024-01-11]\n"
                                               "tuning: tuning.yaml\nvariants: [{tuned: ratio}, {controller: none}]\n";
  ASSERT_EQ(line.evbal("sweep sweep.yaml --out one --quiet").status, 0);
  const Ended before = line.evbal("compare one --against none");
  ASSERT_EQ(before.status, 0) << before.err;
  ASSERT_EQ(line.evbal("tune tuning.yaml --out one --quiet").status, 0);  // as far as a second start may come
  EXPECT_EQ(line.evbal("compare one --against none").out, before.out);
  ASSERT_EQ(line.evbal("tune tuning.yaml --out two --quiet").status, 0);
  EXPECT_EQ(line.evbal("compare two --against none").status, 2);  // what was tuned is no comparison
}

TEST(Tune, RefusesTestDays) {
  const CommandLine line;
  std::ofstream(line.path() / "tuning.yaml") << tuning << "days: [2024-01-03, 2024-01-11]\n";
  const Ended refused = line.evbal("tune tuning.yaml");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("`2024-01-11` is no training day"), std::string::npos) << refused.err;
  EXPECT_FALSE(fs::exists(line.path() / "runs"));
}

/// Puts `to` in place of the first `from` of a file.
void edit(const fs::path& file, const std::string& from, const std::string& to) {
  std::string text = text_of(file);
  ASSERT_NE(text.find(from), std::string::npos) << file;
  std::ofstream(file) << text.replace(text.find(from), from.size(), to);
}

TEST(Sweep, PlaysAnewWhatAnotherPackOrModelGives) {
  const CommandLine line;
  fs::copy(EVBAL_SOURCE_DIR "/experiments/cities/toy-5", line.path() / "town", fs::copy_options::recursive);
  line.scenario("morning.yaml", "");
  edit(line.path() / "morning.yaml", "toy-5", "town");
  std::ofstream(line.path() / "sweep.yaml") << "schema: 1\nscenario: morning.yaml\nseeds: [1]\ndays: [2024-01-11]\n"
                                               "variants: [{controller: ratio}]\n";
  const auto days_played = [&] { return lines_of(line.evbal("sweep sweep.yaml --out out").err); };
  EXPECT_EQ(days_played(), 1);
  EXPECT_EQ(days_played(), 0);
  edit(line.path() / "town" / "README.md", "#", "##");
  EXPECT_EQ(days_played(), 0);
  edit(line.path() / "town" / "city.yaml", "source: \"", "source: \"again ");
  EXPECT_EQ(days_played(), 1);
  edit(line.path() / "town" / "model.json", "\"mean_session_minutes\": ", "\"mean_session_minutes\": 1");
  EXPECT_EQ(days_played(), 1);
  EXPECT_EQ(days_played(), 0);
  EXPECT_EQ(lines_of(text_of(line.path() / "out" / "days.csv")), 2);
}

TEST(Sweep, TellsOfDaysThatAnotherProgramPlayed) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("sweep sweep-small.yaml --quick --out out --quiet").status, 0);
  EXPECT_EQ(line.evbal("sweep sweep-small.yaml --quick --out out --quiet").err, "");
  SQLite::Database((line.path() / "out" / "sweep.sqlite").string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE results SET program = 'evbal 0.0.1 (build 0)' WHERE key IN (SELECT key FROM days WHERE run < 3)");
  const Ended again = line.evbal("sweep sweep-small.yaml --quick --out out --quiet");
  EXPECT_EQ(again.status, 0);
  EXPECT_NE(again.err.find("2 of the days were played by evbal 0.0.1 (build 0)"), std::string::npos) << again.err;
  EXPECT_NE(text_of(line.path() / "out" / "days.csv").find(",evbal 0.0.1 (build 0),"), std::string::npos);
}

TEST(Sweep, IsFoundByItsNameIfItIsShipped) {
  const CommandLine line;
  const Ended swept = line.evbal("sweep sweep-small.yaml --quick --quiet");
  EXPECT_EQ(swept.status, 0) << swept.err;
  EXPECT_EQ(swept.out, "runs/sweep-small-quick/days.csv\n");
  const Ended refused = line.evbal("sweep sweep-smal.yaml");
  EXPECT_EQ(refused.status, 2);
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

// Schedules that are drawn several times.

#include "tests/run/evbal/command_line.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// A morning with a breakdown that is never the same, drawn `runs` times.
class Draws : public ::testing::Test {
 protected:
  void schedule(int runs, const std::string& expect = "") const {
    std::ofstream(line_.path() / "draws.yaml")
        << "schema: 1\nseed: 5\nruns: " << runs << "\nfaults:\n"
        << "  - {name: jam, type: travel.slow, target: {pick: 2}, start: {uniform: {min: \"07:00\", max: \"09:00\"}},\n"
        << "     duration: 40min, magnitude: {uniform: {min: 1.5, max: 4}}}\n"
        << expect;
  }

  /// The row of runs.csv that has `word`, its cells by the header's names.
  std::map<std::string, std::string> row_with(const std::string& folder, const std::string& word) const {
    std::istringstream lines(text_of(line_.path() / folder / "runs.csv"));
    std::string header;
    std::string row;
    std::getline(lines, header);
    while (std::getline(lines, row) && row.find(word) == std::string::npos) {
    }
    std::map<std::string, std::string> cells;
    std::istringstream names(header);
    std::istringstream values(row);
    for (std::string name, value; std::getline(names, name, ',') && std::getline(values, value, ',');) {
      cells[name] = value;
    }
    return cells;
  }

  /// Draws that have their results in a folder, 0 while there is none.
  int finished(const std::string& folder) const {
    try {
      const SQLite::Database database((line_.path() / folder / "runs.sqlite").string(), SQLite::OPEN_READONLY, 1000);
      SQLite::Statement count(database, "SELECT count(*) FROM results");
      return count.executeStep() ? count.getColumn(0).getInt() : 0;
    } catch (const SQLite::Exception&) {
      return 0;
    }
  }

  /// Kills the program as soon as that many draws have their results.
  void kill_after(int draws, const std::string& arguments, const std::string& folder) const {
    const pid_t id = line_.start(arguments);
    for (int i = 0; i < 6000 && finished(folder) < draws; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    kill(id, SIGKILL);
    wait_for(id);
  }

  CommandLine line_;
};

TEST_F(Draws, AreSpreadAndTheWorstCanBeRunAlone) {
  schedule(4);
  const Ended ended = line_.evbal("run morning.yaml --faults draws.yaml --out four");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("nominal, 4 draws of the faults"), std::string::npos) << ended.out;
  const std::string runs = text_of(line_.path() / "four" / "runs.csv");
  EXPECT_EQ(std::count(runs.begin(), runs.end(), '\n'), 5) << runs;
  const std::string spread = text_of(line_.path() / "four" / "distribution.csv");
  EXPECT_TRUE(spread.starts_with("controller,metric,min,q1,median,q3,p90,max,mean,without\n")) << spread;
  EXPECT_EQ(line_.summary("four/without-faults", "fleet_conserved"), "true");

  const std::string influence = text_of(line_.path() / "four" / "influence.csv");
  EXPECT_TRUE(influence.starts_with("controller,metric,fault,quantity,draws,correlation,low,high,p,p_holm\n"));
  EXPECT_NE(influence.find("\nnominal,lost,jam,magnitude,4,"), std::string::npos) << influence;
  EXPECT_NE(influence.find("\nnominal,lost,jam,start,4,"), std::string::npos) << influence;
  EXPECT_NE(ended.out.find("what lost goes with:"), std::string::npos) << ended.out;
  const std::string page = text_of(line_.path() / "four" / "draws.md");
  EXPECT_NE(page.find("| draw | `lost` | jam: "), std::string::npos) << page;
  ASSERT_EQ(line_.evbal("report four").status, 0);
  const std::string report = text_of(line_.path() / "four" / "report.html");
  EXPECT_NE(report.find("Which fault did it under nominal"), std::string::npos);

  const auto at = ended.out.find("worst: ") + 7;
  const std::string worst = ended.out.substr(at, ended.out.find(',', at) - at);
  ASSERT_EQ(line_.evbal("run four/worst.yaml --transport dds --out alone --quiet").status, 0);
  EXPECT_EQ(line_.summary("alone", "digest"), '"' + row_with("four", worst).at("digest") + '"');
  EXPECT_EQ(line_.summary("alone/without-faults", "digest"), line_.summary("four/without-faults", "digest"));
}

TEST_F(Draws, AreTheSameOverDds) {
  schedule(2);
  ASSERT_EQ(line_.evbal("run morning.yaml --faults draws.yaml --out a --quiet").status, 0);
  const Ended over_dds = line_.evbal("run morning.yaml --faults draws.yaml --transport dds --out b --quiet");
  ASSERT_EQ(over_dds.status, 0) << over_dds.err;
  EXPECT_EQ(text_of(line_.path() / "b" / "runs.csv"), text_of(line_.path() / "a" / "runs.csv"));
  EXPECT_NE(row_with("a", "draw-1").at("digest"), row_with("a", "draw-2").at("digest"));
  EXPECT_EQ(over_dds.out, "b\n");
}

TEST_F(Draws, SayInHowManyAnExpectationFails) {
  schedule(3, "expect:\n  - {metric: served, at_least: 9999}\n  - {metric: lost, at_most: 100000}\n");
  const Ended ended = line_.evbal("run morning.yaml --faults draws.yaml --out a");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("served, expected at least 9999, fails in 3 of 3 draws"), std::string::npos) << ended.err;
  EXPECT_EQ(ended.err.find("lost"), std::string::npos) << ended.err;
  EXPECT_TRUE(fs::exists(line_.path() / "a" / "worst.yaml"));
}

TEST_F(Draws, GoOnAfterAKill) {
  schedule(16);
  const std::string command = "run morning.yaml --faults draws.yaml --out killed";
  int before = 0;
  for (const int draws : {1, 4, 6}) {  // the first of them while the day without faults is still played, too
    kill_after(draws, command, "killed");
    ASSERT_GE(finished("killed"), draws);
    ASSERT_LT(finished("killed"), 16);
    EXPECT_GE(finished("killed"), before);
    before = finished("killed");
  }
  const Ended resumed = line_.evbal(command);
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(std::count(resumed.err.begin(), resumed.err.end(), '\n'), 16 - before) << resumed.err;
  EXPECT_NE(resumed.err.find(std::to_string(before + 1) + "/16"), std::string::npos) << resumed.err;
  ASSERT_EQ(line_.evbal("run morning.yaml --faults draws.yaml --out whole --quiet").status, 0);
  for (const char* file : {"runs.csv", "distribution.csv", "worst.yaml", "without-faults/steps.csv"}) {
    EXPECT_EQ(text_of(line_.path() / "killed" / file), text_of(line_.path() / "whole" / file)) << file;
  }
  EXPECT_EQ(line_.evbal(command).status, 2);  // a finished one is not written again
}

TEST_F(Draws, OfAnotherScenarioAreLeftAlone) {
  schedule(16);
  kill_after(2, "run morning.yaml --faults draws.yaml --out killed", "killed");
  const int before = finished("killed");
  ASSERT_GE(before, 2);
  for (const char* other : {"--seed 2 --faults draws.yaml", ""}) {
    const Ended refused = line_.evbal("run morning.yaml --out killed " + std::string(other));
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("holds draws of another scenario"), std::string::npos) << refused.err;
    EXPECT_EQ(finished("killed"), before);
  }
}

}  // namespace
}  // namespace evbal

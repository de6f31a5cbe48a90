// The search for the faults that hurt a day most.

#include "tests/run/evbal/command_line.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// A morning on which jams, outages and spikes are looked for.
class Search : public ::testing::Test {
 protected:
  Search() { schedule(""); }

  void schedule(const std::string& expect) const {
    std::ofstream(line_.path() / "ingredients.yaml")
        << "schema: 1\nseed: 5\nguard: {max_active: 2, min_working_points: 2}\nfaults:\n"
        << "  - {name: jam, type: travel.slow, target: {pick: 2}, arrivals: {poisson: {per_hour: 0.5}},\n"
        << "     duration: {uniform: {min: 10min, max: 60min}}, magnitude: {uniform: {min: 1.5, max: 4}}}\n"
        << "  - {name: spike, type: demand.scale, target: {pick: 1}, arrivals: {poisson: {per_hour: 0.5}},\n"
        << "     duration: {uniform: {min: 10min, max: 60min}}, magnitude: {uniform: {min: 1.2, max: 4}}}\n"
        << expect;
  }

  Ended search(const std::string& out, const std::string& more = "") const {
    return line_.evbal(command(out) + " " + more);
  }

  static std::string command(const std::string& out) {
    return "search morning.yaml --faults ingredients.yaml --budget 12 --out " + out;
  }

  std::string file(const std::string& folder, const std::string& name) const {
    return text_of(line_.path() / folder / name);
  }

  /// Whether two searches left the same, to the byte.
  void expect_same(const std::string& a, const std::string& b) const {
    for (const char* name : {"path.csv", "worst.yaml", "shrunk.yaml", "search.txt"}) {
      EXPECT_FALSE(file(a, name).empty()) << name;
      EXPECT_EQ(file(a, name), file(b, name)) << name;
    }
  }

  /// What a query on a search's days gives, -1 while there are none.
  int number(const std::string& folder, const std::string& query) const {
    try {
      const SQLite::Database database((line_.path() / folder / "search.sqlite").string(), SQLite::OPEN_READONLY, 1000);
      SQLite::Statement row(database, query);
      return row.executeStep() ? row.getColumn(0).getInt() : -1;
    } catch (const SQLite::Exception&) {
      return -1;
    }
  }

  int played(const std::string& folder) const { return number(folder, "SELECT count(*) FROM results"); }

  CommandLine line_;
};

TEST_F(Search, LeavesTheWorstAndWhatRemainsOfIt) {
  const Ended ended = search("a", "--random");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("the worst of 12 random draws"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find(file("a", "search.txt")), std::string::npos) << ended.out;
  EXPECT_TRUE(file("a", "path.csv").starts_with("trial,stage,parent,change,harm,most_harm,faults,schedule\n1,draw,"));
  for (const std::string name : {"worst", "shrunk"}) {
    ASSERT_EQ(line_.evbal("run a/" + name + ".yaml --quiet --out " + name).status, 0);
    const std::string digest = line_.summary(name, "digest");
    EXPECT_EQ(number("a", "SELECT count(*) FROM results WHERE digest = '" + digest.substr(1, digest.size() - 2) + "'"),
              1)
        << name << " " << digest;
  }
}

TEST_F(Search, IsTheSameHoweverManyDaysAtATime) {
  ASSERT_EQ(search("one", "--jobs 1 --quiet").status, 0);
  ASSERT_EQ(search("three", "--jobs 3 --quiet").status, 0);
  expect_same("one", "three");
}

TEST_F(Search, GoesOnAfterAKill) {
  const pid_t id = line_.start(command("killed"));
  for (int i = 0; i < 6000 && played("killed") < 6; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(id, SIGKILL);
  wait_for(id);
  const int before = played("killed");
  ASSERT_GE(before, 6);
  EXPECT_FALSE(fs::exists(line_.path() / "killed" / "shrunk.yaml"));
  const Ended resumed = search("killed");
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(std::count(resumed.err.begin(), resumed.err.end(), '\n'), played("killed") - before) << resumed.err;
  ASSERT_EQ(search("whole", "--quiet").status, 0);
  EXPECT_EQ(played("killed"), played("whole"));
  expect_same("killed", "whole");
  EXPECT_EQ(search("killed").err, "");  // nothing is left to play
}

TEST_F(Search, TestsAController) {
  schedule("expect:\n  - {metric: lost, at_most: 0, under: search}\n");
  const Ended failed = search("a", "--quiet");
  EXPECT_EQ(failed.status, 1);
  EXPECT_NE(failed.err.find("nominal: lost is "), std::string::npos) << failed.err;
  EXPECT_NE(failed.err.find("expected at most 0 under search, with "), std::string::npos) << failed.err;
  EXPECT_NE(failed.err.find("evbal run a/shrunk.yaml"), std::string::npos) << failed.err;
  EXPECT_EQ(line_.evbal("run a/shrunk.yaml --quiet --out alone").status, 1);
  EXPECT_EQ(line_.evbal("run morning.yaml --faults ingredients.yaml --quiet --out one-run").status, 0);

  const int days = played("a");
  schedule("expect:\n  - {metric: lost, at_most: 100000, under: search}\n");
  EXPECT_EQ(search("a", "--quiet").status, 0);
  EXPECT_GE(played("a"), days);  // what was played for one bound serves the other
  schedule("expect:\n  - {metric: lost, at_most: 1, under: day}\n");
  EXPECT_EQ(search("b").status, 2);
}

TEST_F(Search, SaysWhatItCannotSearch) {
  const auto refusal = [&](const std::string& arguments) {
    const Ended ended = line_.evbal("search " + arguments + " --out refused");
    EXPECT_EQ(ended.status, 2) << arguments;
    return ended.err;
  };
  EXPECT_NE(refusal("toy.yaml").find("choose one by --controller"), std::string::npos);
  EXPECT_NE(refusal("morning.yaml --metric los").find("did you mean `lost`"), std::string::npos);
  EXPECT_NE(refusal("morning.yaml --budget 0").find("--budget"), std::string::npos);
  schedule("expect:\n  - {metric: lost, at_most: 0, under: search}\n");
  EXPECT_NE(refusal("morning.yaml --faults ingredients.yaml --metric idle_km").find("leave --metric out"),
            std::string::npos);
  schedule(
      "expect:\n  - {metric: lost, at_most: 0, under: search}\n  - {metric: served, at_least: 9, under: search}\n");
  EXPECT_NE(refusal("morning.yaml --faults ingredients.yaml").find("keep one"), std::string::npos);
  EXPECT_FALSE(fs::exists(line_.path() / "refused"));
}

}  // namespace
}  // namespace evbal

#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Sweeps and tunings in which the days of some variants fail.
class FailedDays : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const { std::ofstream(line_.path() / name) << text; }

  std::string text(const std::string& name) const { return text_of(line_.path() / name); }

  bool exists(const std::string& name) const { return fs::exists(line_.path() / name); }

  /// A controller that sends no car anywhere, after it has done these lines of Python; `here` is the test's folder.
  void write_controller(const std::string& name, const std::string& first) const {
    write(name,
          "import json, os, sys, time\n"
          "here = os.path.dirname(os.path.abspath(__file__))\n"
          "told = json.loads(input())\n" +
              first +
              "for line in sys.stdin:\n"
              "  print('{\"moves\": []}', flush=True)\n");
  }

  /// A sweep of `greedy` and of the controller in this script, two days.
  void write_sweep(const std::string& script) const {
    write("sweep.yaml",
          "schema: 1\nscenario: morning.yaml\ndays: [2024-01-11, 2024-01-12]\nseeds: [1]\nvariants:\n"
          "  - {controller: own, coordinator: [python3, " +
              script + "]}\n  - {controller: greedy}\n");
  }

  CommandLine line_;
};

long rows_of(const std::string& csv) {
  return std::count(csv.begin(), csv.end(), '\n') - 1;
}

TEST_F(FailedDays, ArePlayedOnceMore) {
  write_controller("flaky.py",
                   "if not os.path.exists(here + '/tried'):\n"
                   "  open(here + '/tried', 'w').close()\n"
                   "  raise Exception('bad luck')\n");
  write_sweep("flaky.py");
  const Ended ended = line_.evbal("sweep sweep.yaml --out out --jobs 1");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("failed, is tried again"), std::string::npos) << ended.err;
  EXPECT_EQ(rows_of(text("out/days.csv")), 4);
  EXPECT_FALSE(exists("out/failed.csv"));
}

TEST_F(FailedDays, AreKeptWithTheirReasonBesideTheOthersAndTriedAgainByTheSameCommand) {
  write_controller("barred.py", "if not os.path.exists(here + '/open'):\n  raise Exception('the door is shut')\n");
  write_sweep("barred.py");
  const Ended failed = line_.evbal("sweep sweep.yaml --out out --quiet");
  EXPECT_EQ(failed.status, 3);
  EXPECT_NE(failed.err.find("2 of 4 days failed twice"), std::string::npos) << failed.err;
  EXPECT_NE(failed.err.find("own 2024-01-12 seed 1: "), std::string::npos) << failed.err;
  EXPECT_EQ(rows_of(text("out/days.csv")), 2) << "greedy has played";
  const std::string reasons = text("out/failed.csv");
  EXPECT_TRUE(reasons.starts_with("run,scenario,variant,controller,faults,day,seed,reason\n")) << reasons;
  EXPECT_NE(reasons.find("\n2,morning,own,own,,2024-01-12,1,"), std::string::npos) << reasons;
  EXPECT_NE(reasons.find("the door is shut"), std::string::npos) << reasons;
  const std::string plan = line_.evbal("sweep sweep.yaml --out out --dry-run").out;
  EXPECT_NE(plan.find("4 days, 2 left, of which 2 failed"), std::string::npos) << plan;
  EXPECT_NE(line_.evbal("compare out --against greedy").err.find("2 of 4 days are played, 2 failed"),
            std::string::npos);

  write("open", "");
  const Ended again = line_.evbal("sweep sweep.yaml --out out --quiet");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(rows_of(text("out/days.csv")), 4);
  EXPECT_FALSE(exists("out/failed.csv"));
}

TEST_F(FailedDays, EndAtTheirLimitAndAreKeptAsFailed) {
  write_controller("slow.py", "time.sleep(60)\n");
  write_sweep("slow.py");
  const Ended ended = line_.evbal("sweep sweep.yaml --out out --quiet --jobs 4 --day-limit 3s");
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(text("out/failed.csv").find("took longer than 3 s"), std::string::npos) << text("out/failed.csv");
  EXPECT_EQ(rows_of(text("out/days.csv")), 2) << "greedy has played";
  EXPECT_EQ(line_.evbal("sweep sweep.yaml --day-limit soon").status, 2);
}

TEST_F(FailedDays, OfACandidateKeepItFromWinning) {
  // The more cars the better for the aim, and from 5 on the controller fails.
  write_controller("picky.py", "if told['parameters']['reach'] > 5:\n  raise Exception('too far')\n");
  write("tuning.yaml",
        "schema: 1\nscenario: morning.yaml\ndays: [2024-01-03, 2024-01-02]\nseeds: [7]\nobjective: {lost: 1}\n"
        "candidates: 4\nvariants:\n"
        "  - {controller: own, coordinator: [python3, picky.py], search: {parameters.reach: {from: 1, to: 100}}}\n");
  const Ended tuned = line_.evbal("tune tuning.yaml --out out --quiet");
  ASSERT_EQ(tuned.status, 0) << tuned.err;
  EXPECT_NE(tuned.err.find("cannot win"), std::string::npos) << tuned.err;
  EXPECT_NE(tuned.err.find("too far"), std::string::npos) << tuned.err;
  EXPECT_NE(text("out/tuned.yaml").find("settings: {parameters.reach: 3.162}"), std::string::npos)
      << text("out/tuned.yaml");
  EXPECT_NE(text("out/candidates.csv").find("morning,own,1,1,1,1,,parameters.reach=10"), std::string::npos)
      << text("out/candidates.csv");

  write_controller("picky.py", "raise Exception('never')\n");
  const Ended none = line_.evbal("tune tuning.yaml --out none --quiet");
  EXPECT_EQ(none.status, 3);
  EXPECT_NE(none.err.find("every candidate of own in morning has days that failed"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace evbal

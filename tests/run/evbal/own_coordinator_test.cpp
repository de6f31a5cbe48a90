#include "tests/run/evbal/command_line.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// A coordinator of one's own, for a morning over the bus.
class OwnCoordinator : public ::testing::Test {
 protected:
  OwnCoordinator() { fs::copy_file(EVBAL_SOURCE_DIR "/examples/nearest.py", line_.path() / "nearest.py"); }

  Ended run(const std::string& command, const std::string& more = "--controller mine") const {
    return line_.evbal("run morning.yaml --transport dds --quiet --out run --coordinator \"" + command + "\" " + more);
  }

  /// The run breaks off with `status`, and its one line has these words and names the command.
  void expect_broken(const std::string& command, int status, const std::string& words) const {
    const Ended ended = run(command);
    EXPECT_EQ(ended.status, status) << ended.err;
    EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find(command.substr(0, command.find(' '))), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    fs::remove_all(line_.path() / "run");
  }

  /// The same for a child of evbal-bridge that answers the first question with `answer`.
  void expect_refused(const std::string& answer, const std::string& words) const {
    const fs::path script = line_.path() / "answers.sh";
    std::ofstream(script) << "read opening\nread question\necho '" << answer << "'\nread more\n";
    expect_broken("evbal-bridge sh answers.sh", 3, "line 1 of `sh " + script.string() + "`: " + words);
  }

  CommandLine line_;
};

TEST_F(OwnCoordinator, IsNotedWhereTheRunBreaksOff) {
  std::ofstream(line_.path() / "answers.sh") << "read opening\nread question\necho '{\"moves\": []}'\nread question\n"
                                                "echo '{\"moves\": 7}'\nread more\n";
  EXPECT_EQ(run("evbal-bridge sh answers.sh").status, 3);
  EXPECT_TRUE(fs::exists(line_.path() / "run" / "INCOMPLETE"));
  const SQLite::Database record(line_.path() / "run" / "run.sqlite");
  SQLite::Statement last(record, "SELECT tick, kind, what FROM events ORDER BY rowid DESC LIMIT 1");
  ASSERT_TRUE(last.executeStep());
  EXPECT_EQ(last.getColumn(0).getInt(), 2);
  EXPECT_EQ(last.getColumn(1).getString(), "run failed");
  EXPECT_NE(last.getColumn(2).getString().find("moves"), std::string::npos);
}

TEST_F(OwnCoordinator, InPythonPlansADayThatReplays) {
  const Ended ended = run("evbal-bridge python3 nearest.py", "--controller nearest");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(line_.summary("run", "controller"), "\"nearest\"");
  EXPECT_EQ(line_.summary("run", "fleet_conserved"), "true");
  ASSERT_EQ(line_.evbal("run morning.yaml --controller none --quiet --out idle").status, 0);
  EXPECT_GT(std::stoi(line_.summary("run", "served")), std::stoi(line_.summary("idle", "served")));

  const std::string digest = line_.summary("run", "digest");
  const Ended again = line_.evbal("run run/scenario.resolved.yaml --quiet --out again");
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(line_.summary("again", "digest"), digest);
  const Ended replay = line_.evbal("replay run --quiet");
  EXPECT_EQ(replay.status, 0) << replay.err;
  EXPECT_NE(replay.out.find(digest.substr(1, 32)), std::string::npos) << replay.out;
}

TEST_F(OwnCoordinator, MayBeEvbalsOwnProgram) {
  ASSERT_EQ(run("evbal-coordinator", "--controller greedy").status, 0);
  ASSERT_EQ(line_.evbal("run morning.yaml --controller greedy --quiet --out own").status, 0);
  EXPECT_EQ(line_.summary("run", "digest"), line_.summary("own", "digest"));
}

TEST_F(OwnCoordinator, IsNamedIfItCannotTakePart) {
  expect_broken("no-such-program", 2, "there is no program `no-such-program`");
  expect_broken("evbal-coordinator", 3, "this coordinator has no controller `mine`");
  expect_broken("evbal-bridge no-such-program", 3,
                "`no-such-program` could not be started and owes the plan of tick 0");
  expect_broken("evbal-bridge python3 -c exit(7)", 3, "ended with status 7");
  expect_broken("false", 3, "ended with status 1");
}

TEST_F(OwnCoordinator, IsRefusedWhatItSaysWrong) {
  expect_refused("hello", "not valid JSON");
  expect_refused("{}", "moves: is missing");
  expect_refused(R"({"moves": [], "note": 1})", "note: is no key here");
  expect_refused(R"({"moves": [{"from": 0, "to": 1, "errand": "charge"}]})", "moves[0].count: is missing");
  expect_refused(R"({"moves": [{"from": 0, "to": 5, "count": 1, "errand": "rebalance"}]})",
                 "moves[0].to: a region from 0 to 4 is expected, not 5");
}

TEST_F(OwnCoordinator, NeedsTheBusAndAName) {
  const std::string bridge = "run morning.yaml --coordinator \"evbal-bridge python3 nearest.py\" ";
  const Ended inproc = line_.evbal(bridge + "--controller mine --transport inproc");
  EXPECT_EQ(inproc.status, 2);
  EXPECT_NE(inproc.err.find("takes part over the bus"), std::string::npos) << inproc.err;
  const Ended slash = line_.evbal(bridge + "--controller a/b --transport dds");
  EXPECT_EQ(slash.status, 2);
  EXPECT_NE(slash.err.find("`a/b` is no name"), std::string::npos) << slash.err;
  const Ended taken = run("evbal-bridge python3 nearest.py", "");
  EXPECT_EQ(taken.status, 3);
  EXPECT_NE(taken.err.find("`nominal` is a controller of evbal's own"), std::string::npos) << taken.err;
}

}  // namespace
}  // namespace evbal

#include "tests/run/evbal/command_line.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

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

/// Whether a process of that id has not ended, whoever is to take note of its end.
bool is_alive(const std::string& id) {
  const std::string words = text_of(fs::path("/proc") / std::to_string(std::stoi(id)) / "stat");
  const auto name_ends = words.rfind(") ");
  return name_ends != std::string::npos && words[name_ends + 2] != 'Z';
}

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
  expect_broken("evbal-bridge no-such-program", 2, "there is no program `no-such-program`");
  expect_broken("evbal-bridge python3 -c exit(7)", 3, "ended with status 7");
  expect_broken("false", 3, "ended with status 1");
}

TEST_F(OwnCoordinator, IsShownWithItsLastWords) {
  std::ofstream(line_.path() / "wrong.py") << "input()\nprint(undefined)\n";
  expect_broken("evbal-bridge python3 wrong.py", 3, "NameError: name 'undefined' is not defined");
}

TEST_F(OwnCoordinator, IsRefusedWhatItSaysWrong) {
  expect_refused("hello", "not valid JSON");
  expect_refused("{}", "moves: is missing");
  expect_refused(R"({"moves": [], "note": 1})", "note: is no key here");
  expect_refused(R"({"moves": [{"from": 0, "to": 1, "errand": "charge"}]})", "moves[0].count: is missing");
  expect_refused(R"({"moves": [{"from": 0, "to": 5, "count": 1, "errand": "rebalance"}]})",
                 "moves[0].to: a region from 0 to 4 is expected, not 5");
}

TEST_F(OwnCoordinator, SeesTheEndOfItsInputAndMayFinish) {
  std::ofstream(line_.path() / "learns.sh") << "read opening\n"
                                               "while read question; do echo '{\"moves\": []}'; done\n"
                                               "sleep 0.5\n"
                                               "echo learnt >learnt.txt\n"
                                               "echo said on stdout\n"
                                               "echo said on stderr >&2\n";
  const Ended ended = run("evbal-bridge sh learns.sh");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(text_of(line_.path() / "learnt.txt"), "learnt\n");
  const std::string log = text_of(line_.path() / "run" / "processes" / "coordinator.log");
  EXPECT_NE(log.find("said on stdout\n"), std::string::npos) << log;
  EXPECT_NE(log.find("said on stderr\n"), std::string::npos) << log;
}

TEST_F(OwnCoordinator, IsAskedToEndAndThenKilledIfItGoesOn) {
  std::ofstream(line_.path() / "stays.sh") << "trap 'echo asked >asked.txt' TERM\n"
                                              "echo $$ >id.txt\n"
                                              "read opening\n"
                                              "while read question; do echo '{\"moves\": []}'; done\n"
                                              "while :; do sleep 0.1; done\n";
  const Ended ended = run("evbal-bridge sh stays.sh");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(text_of(line_.path() / "asked.txt"), "asked\n");
  EXPECT_FALSE(is_alive(text_of(line_.path() / "id.txt")));
}

TEST_F(OwnCoordinator, EndsWithABridgeThatIsKilled) {
  std::ofstream(line_.path() / "kills.sh") << "trap '' TERM\n"
                                              "echo $$ >>ids.txt\n"
                                              "read opening\n"
                                              "read question\n"
                                              "[ $(wc -l <ids.txt) -gt 1 ] || kill -KILL $PPID\n"
                                              "while :; do echo '{\"moves\": []}'; read question || sleep 0.1; done\n";
  // Without faults there is no second day beside this one, whose child would add its id.
  const Ended ended =
      run("evbal-bridge sh kills.sh", "--controller mine --set 'faults={schema: 1, seed: 1, faults: []}'");
  ASSERT_EQ(ended.status, 0) << ended.err;
  SQLite::Database record(line_.path() / "run" / "run.sqlite");
  EXPECT_EQ(record.execAndGet("SELECT count(*) FROM events WHERE kind = 'process ended'").getInt(), 1);
  std::istringstream ids(text_of(line_.path() / "ids.txt"));
  int count = 0;
  for (std::string id; ids >> id; ++count) {
    EXPECT_FALSE(is_alive(id)) << "child " << count;
  }
  EXPECT_EQ(count, 2);
}

TEST_F(OwnCoordinator, NeedsAName) {
  const std::string bridge = "run morning.yaml --coordinator \"evbal-bridge python3 nearest.py\" ";
  const Ended slash = line_.evbal(bridge + "--controller a/b --transport dds");
  EXPECT_EQ(slash.status, 2);
  EXPECT_NE(slash.err.find("`a/b` is no name"), std::string::npos) << slash.err;
  const Ended taken = run("evbal-bridge python3 nearest.py", "");
  EXPECT_EQ(taken.status, 3);
  EXPECT_NE(taken.err.find("`nominal` is a controller of evbal's own"), std::string::npos) << taken.err;
}

}  // namespace
}  // namespace evbal

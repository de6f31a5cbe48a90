#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Days in one process, planned by a controller outside of it.
class OwnController : public ::testing::Test {
 protected:
  OwnController() { fs::copy_file(EVBAL_SOURCE_DIR "/examples/nearest.py", line_.path() / "nearest.py"); }

  Ended run(const std::string& command, const std::string& more = "--controller mine",
            const std::string& scenario = "morning.yaml --transport inproc") const {
    fs::remove_all(line_.path() / "run");
    return line_.evbal("run " + scenario + " --quiet --out run --coordinator \"" + command + "\" " + more);
  }

  /// A child that hears the first question and then does what a shell is told ends the run with `status` and one line
  /// with these words.
  void expect_broken(const std::string& words_of_shell, int status, const std::string& words) const {
    line_write("answers.sh", "read opening\nread question\n" + words_of_shell + "\n");
    const Ended ended = run("sh answers.sh");
    EXPECT_EQ(ended.status, status) << ended.err;
    EXPECT_NE(ended.err.find("line 1 of `sh "), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_LT(ended.err.size(), 500U);
  }

  void line_write(const std::string& name, const std::string& text) const {
    std::ofstream(line_.path() / name) << text;
  }

  CommandLine line_;
};

TEST_F(OwnController, PlansTheSameDayAsOnTheBus) {
  ASSERT_EQ(run("python3 nearest.py").status, 0) << text_of(line_.path() / "err.txt");
  const std::string digest = line_.summary("run", "digest");
  EXPECT_EQ(line_.summary("run", "controller"), "\"mine\"");
  EXPECT_EQ(line_.summary("run", "coordinator_digest").size(), 34U);
  const Ended replay = line_.evbal("replay run --quiet");
  EXPECT_EQ(replay.status, 0) << replay.err;
  ASSERT_EQ(run("evbal-bridge python3 nearest.py", "--controller mine", "morning.yaml --transport dds").status, 0);
  EXPECT_EQ(line_.summary("run", "digest"), digest);
}

TEST_F(OwnController, OnEvbalsLibrariesPlansAsInThisProcess) {
  for (const std::string faults : {"lying-sensors.yaml", "starved-solver.yaml", "stadium.yaml", "lossy-reports.yaml"}) {
    const std::string more = "--controller robust --engine cuts --faults " + faults;
    ASSERT_EQ(run("evbal-coordinator", more, "toy.yaml --transport inproc").status, 0)
        << text_of(line_.path() / "err.txt");
    const std::string digest = line_.summary("run", "digest");
    ASSERT_EQ(line_.evbal("run toy.yaml --transport inproc --quiet --out own-" + faults + " " + more).status, 0);
    EXPECT_EQ(line_.summary("own-" + faults, "digest"), digest) << faults;
  }
}

TEST_F(OwnController, ThatGoesWrongIsNamedInOneLine) {
  expect_broken("exit 0", 3, "it ended with status 0 and owes the plan of tick 0");
  expect_broken("kill -SEGV $$", 3, "was ended by signal 11");
  expect_broken("echo '{\"moves\": [{\"from\": 0, \"count\": NaN}]}'; read more", 2, "not valid JSON");
  expect_broken("printf '{\"moves\":'", 3, "after half a line, `{\"moves\":`, and owes the plan of tick 0");
  expect_broken("head -c 10000000 /dev/zero | tr '\\0' x; read more", 2, "is longer than 8 MB");
  expect_broken("head -c 10000000 /dev/zero | tr '\\0' '\\n'; read more", 2, "not valid JSON");
  expect_broken("echo hello; read more", 2, "not valid JSON");
  expect_broken("echo '{\"moves\": [{\"from\": 0, \"to\": 5, \"count\": 1, \"errand\": \"charge\"}]}'; read more", 2,
                "moves[0].to: a region from 0 to 4 is expected, not 5");
  expect_broken("echo oh dear >&2; exit 7", 3, "it ended with status 7 and owes the plan of tick 0: oh dear");
  expect_broken("(sleep 300) & exit 0", 3, "it ended with status 0 and owes the plan of tick 0");
}

TEST_F(OwnController, ThatCannotBeStartedIsNamed) {
  const Ended missing = run("no-such-program");
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("there is no program `no-such-program`"), std::string::npos) << missing.err;
  const Ended taken = run("python3 nearest.py", "");
  EXPECT_EQ(taken.status, 2);
  EXPECT_NE(taken.err.find("`nominal` is a controller of evbal's own"), std::string::npos) << taken.err;
  const Ended unknown = run("evbal-coordinator");
  EXPECT_EQ(unknown.status, 3);
  EXPECT_NE(unknown.err.find("this coordinator has no controller `mine`"), std::string::npos) << unknown.err;
}

TEST_F(OwnController, PrintsIntoTheRunsLog) {
  line_write(
      "learns.sh",
      "read opening\nwhile read question; do echo '{\"moves\": []}'; done\necho on stdout\necho on stderr >&2\n");
  const Ended ended = run("sh learns.sh");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const std::string log = text_of(line_.path() / "run" / "processes" / "coordinator.log");
  EXPECT_NE(log.find("on stdout\n"), std::string::npos) << log;
  EXPECT_NE(log.find("on stderr\n"), std::string::npos) << log;
}

const std::string built = EVBAL_OWN_CONTROLLERS;

TEST_F(OwnController, InASharedLibraryPlansAsInPython) {
  const std::string more =
      "--controller mine --set charging.top_up=true --set parameters.reach=6 "
      "--set parameters.ahead=0.7";
  ASSERT_EQ(run("python3 nearest.py", more).status, 0) << text_of(line_.path() / "err.txt");
  const std::string digest = line_.summary("run", "digest");
  EXPECT_GT(std::stoi(line_.summary("run", "top_ups")), 0);
  ASSERT_EQ(run(built + "/libnearest.so", more).status, 0) << text_of(line_.path() / "err.txt");
  EXPECT_EQ(line_.summary("run", "digest"), digest);
  EXPECT_EQ(line_.evbal("replay run --quiet").status, 0) << text_of(line_.path() / "err.txt");
  ASSERT_EQ(run(built + "/libnearest.so", more, "morning.yaml --transport dds").status, 0)
      << text_of(line_.path() / "err.txt");
  EXPECT_EQ(line_.summary("run", "digest"), digest);
  ASSERT_EQ(run("python3 nearest.py").status, 0);
  EXPECT_NE(line_.summary("run", "digest"), digest) << "with other parameters";
}

TEST_F(OwnController, InASharedLibraryIsHeldToTheSame) {
  const auto expect_wrong = [&](const std::string& fault, int status, const std::string& words) {
    const Ended ended = run(built + "/libfaulty.so", "--controller mine --set parameters.fault=" + fault);
    EXPECT_EQ(ended.status, status) << ended.err;
    EXPECT_NE(ended.err.find("libfaulty.so`" + words), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  };
  EXPECT_EQ(run(built + "/libfaulty.so", "--controller mine").status, 0) << text_of(line_.path() / "err.txt");
  expect_wrong("create", 3, ": evbal_create made no controller");
  expect_wrong("refuse", 3, ": evbal_plan gave -1 for tick 0");
  expect_wrong("region", 2, ": moves[0].to: a region from 0 to 4 is expected, not 5");
  expect_wrong("errand", 2, ": moves[0].errand: `rebalance` or `charge` is expected");
  expect_wrong("count", 2, ": moves[0].count: region 0 has");
  expect_wrong("twice", 2, ": moves: rebalance from 0 to 1 is given twice");
  expect_wrong("room", 2, ": there is room for 50 moves, not 51");
  line_write("empty.so", "");
  const Ended empty = run("./empty.so");
  EXPECT_EQ(empty.status, 2);
  EXPECT_NE(empty.err.find("is no library that can be loaded"), std::string::npos) << empty.err;
  const Ended missing = run("./none.so");
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("there is no library"), std::string::npos) << missing.err;
}

}  // namespace
}  // namespace evbal

#include "tests/run/evbal/command_line.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Studies of controllers outside of evbal.
class OwnStudy : public ::testing::Test {
 protected:
  OwnStudy() {
    fs::copy_file(EVBAL_SOURCE_DIR "/examples/nearest.py", line_.path() / "nearest.py");
    write("sweep.yaml",
          "schema: 1\nscenario: morning.yaml\ndays: [2024-01-11, 2024-01-12]\nseeds: [1, 2, 3]\nvariants:\n"
          "  - controller: greedy\n"
          "  - {controller: nearest, coordinator: [python3, nearest.py], settings: {parameters.ahead: [0, 0.5]}}\n");
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(line_.path() / name) << text; }

  std::string days_of(const std::string& folder) const { return text_of(line_.path() / folder / "days.csv"); }

  /// How many days a sweep had still to play.
  long played(const std::string& arguments) const {
    const Ended ended = line_.evbal("sweep " + arguments);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return std::count(ended.err.begin(), ended.err.end(), '\n');
  }

  /// Whether a process is left whose command names the test's folder.
  bool any_left() const {
    for (const auto& process : fs::directory_iterator("/proc")) {
      const std::string id = process.path().filename();
      if (id.find_first_not_of("0123456789") == std::string::npos &&
          text_of(process.path() / "cmdline").find(line_.path().string()) != std::string::npos) {
        return true;
      }
    }
    return false;
  }

  CommandLine line_;
};

int results_in(const fs::path& file) {
  try {
    return SQLite::Database(file.string(), SQLite::OPEN_READONLY, 1000)
        .execAndGet("SELECT count(*) FROM results")
        .getInt();
  } catch (const SQLite::Exception&) {
    return 0;
  }
}

TEST_F(OwnStudy, IsKilledAndGoesOnToTheSameBytesForAnyNumberOfJobs) {
  const pid_t id = line_.start("sweep sweep.yaml --jobs 2 --out killed");
  for (int i = 0; i < 3000 && results_in(line_.path() / "killed" / "sweep.sqlite") < 8; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(id, SIGKILL);
  wait_for(id);
  for (int i = 0; i < 400 && any_left(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_FALSE(any_left());
  const int before = results_in(line_.path() / "killed" / "sweep.sqlite");
  ASSERT_GE(before, 8);
  ASSERT_LT(before, 18);
  EXPECT_EQ(played("sweep.yaml --jobs 2 --out killed"), 18 - before);
  EXPECT_EQ(played("sweep.yaml --jobs 1 --out whole"), 18);
  EXPECT_TRUE(days_of("killed") == days_of("whole"));
  EXPECT_TRUE(text_of(line_.path() / "killed" / "steps.csv") == text_of(line_.path() / "whole" / "steps.csv"));
  const Ended compared = line_.evbal("compare whole --against greedy");
  EXPECT_EQ(compared.status, 0) << compared.err;
  EXPECT_NE(compared.out.find("parameters.ahead=0.5"), std::string::npos) << compared.out;
}

TEST_F(OwnStudy, PlaysAnewTheDaysOfAScriptThatIsEdited) {
  EXPECT_EQ(played("sweep.yaml --out out"), 18);
  EXPECT_EQ(played("sweep.yaml --out out"), 0);
  const std::string script = text_of(line_.path() / "nearest.py");
  write("nearest.py", script + "# edited\n");
  EXPECT_EQ(played("sweep.yaml --out out"), 12);
  write("nearest.py", script);
  EXPECT_EQ(played("sweep.yaml --out out"), 0);
}

TEST_F(OwnStudy, NamesTheDayAndTheLineThatWasWrong) {
  write("wrong.py",
        "input()\nfor _ in range(3):\n  input()\n  print('{\"moves\": []}', flush=True)\nprint(undefined)\n");
  write("wrong.yaml",
        "schema: 1\nscenario: morning.yaml\ndays: [2024-01-11]\nseeds: [1]\nvariants:\n"
        "  - controller: greedy\n"
        "  - {controller: wrong, coordinator: [python3, wrong.py]}\n");
  const Ended ended = line_.evbal("sweep wrong.yaml --out out --quiet");
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(ended.err.find("wrong 2024-01-11 seed 1: line 4 of `python3 "), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("NameError: name 'undefined' is not defined"), std::string::npos) << ended.err;
  EXPECT_EQ(results_in(line_.path() / "out" / "sweep.sqlite"), 1);
  write("wrong.yaml",
        "schema: 1\nscenario: morning.yaml\ndays: [2024-01-11]\nseeds: [1]\n"
        "variants: [{controller: wrong, coordinator: [no-such-program]}]\n");
  const Ended missing = line_.evbal("sweep wrong.yaml --out none");
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("there is no program `no-such-program`"), std::string::npos) << missing.err;
}

TEST_F(OwnStudy, ThatIsShippedTunesAndComparesAllLanguages) {
  const std::string path = "PATH=" EVBAL_OWN_CONTROLLERS ":" EVBAL_SOURCE_DIR "/examples:$PATH";
  for (const std::string jobs : {"1", "2"}) {
    const Ended ended =
        line_.evbal("sweep own-controllers.yaml --quick --quiet --out out-" + jobs + " --jobs " + jobs, path);
    ASSERT_EQ(ended.status, 0) << ended.err;
  }
  for (const std::string file : {"days.csv", "steps.csv", "tuned.yaml", "candidates.csv", "page.md"}) {
    EXPECT_TRUE(text_of(line_.path() / "out-1" / file) == text_of(line_.path() / "out-2" / file)) << file;
  }
  const std::string tuned = text_of(line_.path() / "out-1" / "tuned.yaml");
  EXPECT_NE(tuned.find("coordinator: [\"libnearest.so\"]"), std::string::npos) << tuned;
  EXPECT_NE(tuned.find("parameters.reach: "), std::string::npos) << tuned;
  const Ended compared = line_.evbal("compare out-1 --against greedy");
  EXPECT_EQ(compared.status, 0) << compared.err;
  for (const std::string variant : {"robust", "in-python", "in-c", "in-cpp"}) {
    EXPECT_NE(compared.out.find(variant), std::string::npos) << compared.out;
  }
}

}  // namespace
}  // namespace evbal

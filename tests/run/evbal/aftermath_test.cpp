// What is left of a run whose launcher was killed, and who removes it.

#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>
#include <spawn.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Waits up to a minute.
bool comes_true(const std::function<bool()>& condition) {
  for (int i = 0; i < 6000; ++i) {
    if (condition()) {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/// Whether a process has `word` in its command line.
bool runs(const std::string& word) {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    if (text_of(entry.path() / "cmdline").find(word) != std::string::npos) {
      return true;
    }
  }
  return false;
}

TEST(Aftermath, OfAKilledLauncherIsInNobodysWay) {
  const CommandLine line;
  const fs::path run = line.path() / "runs" / "a";
  const std::string command = "run morning.yaml --transport dds --controller robust --quiet --out " + run.string();
  const pid_t launcher = line.start(command);
  ASSERT_TRUE(comes_true([&] {
    const std::string mark = text_of(run / "INCOMPLETE");
    return mark.find("of 36") != std::string::npos && mark.find("recorded 0 ") == std::string::npos;
  }));
  kill(launcher, SIGSTOP);  // or the day might end before it is killed
  EXPECT_EQ(line.evbal(command).status, 2) << "a run goes on there";
  kill(launcher, SIGKILL);
  wait_for(launcher);
  EXPECT_TRUE(fs::exists(run / "INCOMPLETE"));
  EXPECT_TRUE(fs::exists(run / "journals"));
  EXPECT_TRUE(comes_true([&] { return !runs(run.string()); })) << "the run's processes end with it";
  const std::string journals = "runs/a/journals, of a run that broke off";
  EXPECT_NE(line.evbal("doctor").out.find(journals), std::string::npos);
  EXPECT_TRUE(fs::exists(run / "journals"));
  EXPECT_NE(line.evbal("doctor --clean").out.find("removed " + journals), std::string::npos);
  EXPECT_FALSE(fs::exists(run / "journals"));
  EXPECT_TRUE(fs::exists(run / "run.sqlite")) << "a record is not left over";

  const Ended again = line.evbal(command);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_FALSE(fs::exists(run / "INCOMPLETE"));
  EXPECT_EQ(line.evbal(command).status, 2) << "a record that is complete is kept";
  EXPECT_EQ(line.evbal("doctor").out.find(journals), std::string::npos);
}

TEST(Aftermath, OfAKilledLauncherHoldsNoKeysForLong) {
  const CommandLine line;
  const fs::path run = line.path() / "runs" / "a";
  const std::string command = "run morning.yaml --transport dds --set security=on --quiet --out " + run.string();
  const pid_t launcher = line.start(command);
  const bool begun = comes_true([&] { return fs::exists(run / "keys" / "agent-4" / "grant.p7s"); });
  kill(launcher, SIGKILL);
  wait_for(launcher);
  ASSERT_TRUE(begun);
  EXPECT_TRUE(comes_true([&] { return !runs(run.string()); })) << "the run's processes end with it";
  const std::string keys = "runs/a/keys, of a run that broke off";
  EXPECT_NE(line.evbal("doctor").out.find(keys), std::string::npos);
  EXPECT_NE(line.evbal("doctor --clean").out.find("removed " + keys), std::string::npos);
  EXPECT_FALSE(fs::exists(run / "keys"));
}

TEST(Aftermath, IsLookedForBesideFoldersThatCannotBeRead) {
  const CommandLine line;
  fs::create_directories(line.path() / "runs");
  fs::create_symlink("loop", line.path() / "runs" / "loop");
  const Ended doctor = line.evbal("doctor");
  EXPECT_EQ(doctor.err.find("rror"), std::string::npos) << doctor.err;
  EXPECT_NE(doctor.out.find("processors"), std::string::npos) << doctor.out;
}

TEST(Aftermath, OfAHangUpIsNoneUnderNohup) {
  const CommandLine line;
  const pid_t launcher = line.start("run morning.yaml --transport dds --quiet --out a", "trap '' HUP; ");
  ASSERT_TRUE(comes_true([&] { return fs::exists(line.path() / "a" / "INCOMPLETE"); }));
  kill(launcher, SIGHUP);
  EXPECT_EQ(wait_for(launcher), 0) << text_of(line.path() / "err.txt");
  EXPECT_TRUE(fs::exists(line.path() / "a" / "summary.json"));
}

TEST(Aftermath, OfAProcessThatDidNotEndIsRemoved) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --controller none --quiet --out a").status, 0);
  int input[2];
  ASSERT_EQ(pipe(input), 0);
  std::vector<std::string> words = {"evbal-faults",
                                    "--name",
                                    "faults",
                                    "--run",
                                    "1-12345",
                                    "--domain",
                                    "90",
                                    "--participant",
                                    "2",
                                    "--participants",
                                    "8",
                                    "--scenario",
                                    line.path() / "a" / "scenario.resolved.yaml",
                                    "--journal",
                                    line.path() / "journal",
                                    "--patience",
                                    "600"};
  std::vector<char*> pointers;
  for (auto& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input[0], STDIN_FILENO);
  pid_t left = 0;
  const std::string program = fs::path(EVBAL_PROGRAM).parent_path() / "evbal-faults";
  ASSERT_EQ(posix_spawn(&left, program.c_str(), &files, nullptr, pointers.data(), environ), 0);
  const std::string name = "evbal-faults (process " + std::to_string(left) + ") of run 1-12345";
  ASSERT_TRUE(comes_true([&] { return line.evbal("doctor").out.find(name) != std::string::npos; }));
  EXPECT_EQ(kill(left, 0), 0);
  EXPECT_NE(line.evbal("doctor --clean").out.find("removed " + name), std::string::npos);
  int status = 0;
  waitpid(left, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
}

}  // namespace
}  // namespace evbal

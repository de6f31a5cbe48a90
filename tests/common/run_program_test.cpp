#include "common/run_program.hpp"

#include "common/error.hpp"
#include "common/spawn.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>

namespace evbal {
namespace {

using namespace std::chrono_literals;

ProgramResult shell(const std::string& script, std::chrono::milliseconds at_most = 60s) {
  return run_program({"sh", "-c", script}, at_most);
}

TEST(RunProgram, TellsItsTwoOutputsApart) {
  const ProgramResult result = shell("echo 4711; echo 'a warning' >&2; exit 7");
  EXPECT_EQ(result.output, "4711\n");
  EXPECT_EQ(result.errors, "a warning\n");
  EXPECT_EQ(ending(result.status), "ended with status 7");
}

TEST(RunProgram, HearsLongAnswersToTheEnd) {
  const ProgramResult result = shell("head -c 1000000 /dev/zero; head -c 300000 /dev/zero >&2");
  EXPECT_EQ(result.output.size(), 1000000U);
  EXPECT_EQ(result.errors.size(), 300000U);
  EXPECT_EQ(result.status, 0);
}

TEST(RunProgram, GivesNoInputAndNeedsNoShell) {
  EXPECT_EQ(run_program({"cat"}, 60s).output, "");
  EXPECT_EQ(run_program({"echo", "$HOME; 'x'"}, 60s).output, "$HOME; 'x'\n");
}

TEST(RunProgram, SaysThatItCannotBeStarted) {
  try {
    run_program({"no-such-program", "-x"}, 60s);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "`no-such-program -x` cannot be started: No such file or directory");
  }
}

TEST(RunProgram, KillsOneThatDoesNotEnd) {
  const Folder folder;
  const auto file = (folder.path() / "id").string();
  EXPECT_THROW(shell("echo $$ >" + file + "; trap '' TERM; while :; do sleep 1; done", 500ms), Error);
  EXPECT_EQ(kill(std::stoi(text_of(file)), 0), -1) << "is no more";
}

TEST(RunProgram, DoesNotWaitForWhatTheProgramLeftBehind) {
  const ProgramResult result = shell("sleep 20 & echo $!");
  kill(std::stoi(result.output), SIGKILL);
  EXPECT_EQ(result.status, 0);
}

TEST(Spawn, LeavesOnlyTheStandardStreamsOpen) {
  const int inherited = dup(STDERR_FILENO);
  EXPECT_EQ(run_program({"ls", "/proc/self/fd"}, 60s).output, "0\n1\n2\n3\n") << "3 is the folder that ls reads";
  close(inherited);
}

TEST(Spawn, EndsOnSignalsAsUsual) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(shell("kill -PIPE $$").status, SIGPIPE);
  std::signal(SIGPIPE, before);
}

TEST(Spawn, TellsItsOwnEndFromOneByOthers) {
  std::signal(SIGINT, SIG_DFL);  // ignored where this test runs in the background
  std::signal(SIGHUP, SIG_DFL);
  for (const char* own : {"exit 3", "kill -ABRT $$", "kill -SEGV $$", "kill -BUS $$", "kill -ILL $$", "kill -FPE $$",
                          "kill -SYS $$", "kill -TRAP $$", "kill -XFSZ $$", "kill -PIPE $$"}) {
    EXPECT_FALSE(ended_from_outside(shell(own).status)) << own;
  }
  for (const char* outside : {"kill -KILL $$", "kill -TERM $$", "kill -INT $$", "kill -HUP $$"}) {
    EXPECT_TRUE(ended_from_outside(shell(outside).status)) << outside;
  }
}

}  // namespace
}  // namespace evbal

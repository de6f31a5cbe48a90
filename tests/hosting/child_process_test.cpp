#include "agents/hosting/child_process.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <functional>
#include <thread>

namespace evbal {
namespace {

using namespace std::chrono_literals;

Command shell(const std::string& words) {
  return {"sh", "-c", words};
}

/// What is wrong with `work`, and whose fault it is.
void expect_error(ExitStatus status, const std::string& words, const std::function<void()>& work) {
  try {
    work();
    FAIL() << "no error with `" << words << "`";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), status) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_LT(std::string(error.what()).size(), 400U);
  }
}

/// Whether a process of that id is there and has not ended, after at most two seconds.
bool stays(const std::string& id) {
  for (int i = 0; i < 100; ++i) {
    const std::string words = text_of("/proc/" + std::to_string(std::stoi(id)) + "/stat");
    const auto name_ends = words.rfind(") ");
    if (name_ends == std::string::npos || words[name_ends + 2] == 'Z') {
      return false;
    }
    std::this_thread::sleep_for(20ms);
  }
  return true;
}

TEST(ChildProcess, AnswersLineByLine) {
  ChildProcess child(shell("while read line; do echo \"$line!\"; done"));
  child.write("one");
  EXPECT_EQ(child.read("an answer"), "one!");
  child.write(std::string(1'000'000, 'x'));
  EXPECT_EQ(child.read("an answer").size(), 1'000'001U);
  EXPECT_TRUE(child.place().starts_with("line 2 of `sh -c while")) << child.place();
}

TEST(ChildProcess, ThatSaysNothingIsWaitedForNoLongerThanItMay) {
  ChildProcess silent(shell("read line; sleep 60"), STDERR_FILENO, 300ms);
  silent.write("question");
  expect_error(ExitStatus::run_failed, "nothing came within", [&] { silent.read("the plan"); });
  ChildProcess half(shell("read line; printf '{\"moves'; sleep 60"), STDERR_FILENO, 300ms);
  half.write("question");
  expect_error(ExitStatus::run_failed, "but half a line, `{\"moves`; it owes the plan", [&] { half.read("the plan"); });
  expect_error(ExitStatus::run_failed, "owes the plan", [&] { half.read("the plan"); });
}

TEST(ChildProcess, ThatDoesNotListenIsWaitedForNoLongerThanItMay) {
  ChildProcess deaf(shell("sleep 60"), STDERR_FILENO, 300ms);
  expect_error(ExitStatus::run_failed, "line 1 of `sh -c sleep 60`: the question for it is not read",
               [&] { deaf.write(std::string(1'000'000, 'x')); });
}

TEST(ChildProcess, ThatEndsEarlyIsNamedWithWhatItOwes) {
  const auto read_from = [](const std::string& words) {
    ChildProcess child(shell(words));
    child.write("question");
    child.read("the plan");
  };
  expect_error(ExitStatus::run_failed, "it ended with status 0 and owes the plan",
               [&] { read_from("read line; exit 0"); });
  expect_error(ExitStatus::run_failed, "it ended with status 0 after half a line, `half`, and owes the plan",
               [&] { read_from("read line; printf half"); });
  expect_error(ExitStatus::run_failed, "was ended by signal 11", [&] { read_from("read line; kill -SEGV $$"); });
}

TEST(ChildProcess, ThatSaysTooMuchIsRefused) {
  ChildProcess endless(shell("read line; head -c 10000000 /dev/zero; sleep 60"));
  endless.write("question");
  expect_error(ExitStatus::bad_input, "line 1 of", [&] { endless.read("the plan"); });
  ChildProcess early(shell("read line; echo one; echo two; read line"));
  early.write("question");
  early.read("the plan");
  std::this_thread::sleep_for(100ms);
  expect_error(ExitStatus::bad_input, "`two` was said before it was asked for", [&] { early.write("question"); });
}

TEST(ChildProcess, LeavesNobodyBehindWhomItForked) {
  const Folder folder;
  const std::string id = (folder.path() / "id.txt").string();
  {  // ends when it is asked to, without the process that it started
    ChildProcess child(shell("sleep 60 & echo $! >" + id + "; read line; echo answer; read line"));
    child.write("question");
    EXPECT_EQ(child.read("the plan"), "answer");
  }
  EXPECT_FALSE(stays(text_of(id)));
  ChildProcess gone(shell("sleep 60 & echo $! >" + id + "; read line; exit 0"));  // which holds its output open
  gone.write("question");
  expect_error(ExitStatus::run_failed, "ended with status 0 and owes", [&] { gone.read("the plan"); });
  EXPECT_FALSE(stays(text_of(id)));
}

TEST(ChildProcess, LeavesNobodyBehindWhoHasLeftItsGroup) {
  const Folder folder;
  const std::string id = (folder.path() / "id.txt").string();
  {
    ChildProcess child(shell("setsid sh -c 'echo $$ >" + id + "; sleep 60 & wait' & until [ -s " + id +
                             " ]; do sleep 0.01; done; read line; echo answer; read line"));
    child.write("question");
    EXPECT_EQ(child.read("the plan"), "answer");
  }
  EXPECT_FALSE(stays(text_of(id)));
}

}  // namespace
}  // namespace evbal

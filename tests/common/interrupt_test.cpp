#include "common/interrupt.hpp"

#include "common/error.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <string>

namespace evbal {
namespace {

/// Ends this process with what check_interrupt() throws on stderr, with status 0 if it throws nothing.
[[noreturn]] void end_by_check() {
  try {
    check_interrupt();
  } catch (const Error& error) {
    std::fputs(error.what(), stderr);
    _exit(static_cast<int>(error.status()));
  }
  _exit(0);
}

TEST(InterruptDeathTest, FirstSignalAsksTheRunToEnd) {
  for (const auto& [signal, words] :
       {std::pair(SIGINT, "interrupted"), std::pair(SIGTERM, "asked to end"), std::pair(SIGHUP, "asked to end")}) {
    EXPECT_EXIT(
        {
          std::signal(signal, SIG_DFL);
          catch_interrupts();
          raise(signal);
          end_by_check();
        },
        testing::ExitedWithCode(3), words);
  }
}

TEST(InterruptDeathTest, SecondSignalEndsTheProcess) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        raise(SIGTERM);
        raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
}

TEST(InterruptDeathTest, WhatWasInheritedAsIgnoredStaysIgnored) {
  for (const int signal : {SIGHUP, SIGINT}) {
    EXPECT_EXIT(
        {
          std::signal(signal, SIG_IGN);
          catch_interrupts();
          raise(signal);
          raise(signal);
          end_by_check();
        },
        testing::ExitedWithCode(0), "");
  }
}

TEST(InterruptDeathTest, RunThatDoesNotEndInTimeIsEnded) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        raise(SIGTERM);
        if (alarm(0) == 0) {
          _exit(0);  // it would go on for ever
        }
        raise(SIGALRM);  // as if the time was up
      },
      testing::ExitedWithCode(3), "asked to end by a signal, did not end within 10 s");
}

}  // namespace
}  // namespace evbal

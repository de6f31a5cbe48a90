// Packets that are lost and late below the middleware: the day is the one without.

#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

namespace evbal {
namespace {

/// What a child of this process finds forbidden, empty if nothing is.
std::string forbidden() {
  const pid_t child = fork();
  if (child == 0) {
    const bool allowed = unshare(CLONE_NEWNET) == 0 || unshare(CLONE_NEWUSER | CLONE_NEWNET) == 0;
    _exit(allowed ? 0 : 1);
  }
  return wait_for(child) != 0 ? "network namespaces" : access("/dev/net/tun", R_OK | W_OK) != 0 ? "/dev/net/tun" : "";
}

TEST(LossyNetwork, ChangesNothingButTheTimeItTakes) {
  if (const std::string what = forbidden(); !what.empty()) {
    GTEST_SKIP() << what << " may not be used here";
  }
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --out a --quiet").status, 0);
  line.scenario("lossy.yaml", "network: {loss: 0.1, delay: 20ms}\n");
  const Ended lossy = line.evbal("run lossy.yaml --transport dds --out b --quiet");
  ASSERT_EQ(lossy.status, 0) << lossy.err;
  EXPECT_EQ(line.summary("b", "digest"), line.summary("a", "digest"));
  EXPECT_EQ(line.summary("b", "agents"), "5");
  EXPECT_EQ(line.summary("b", "loss"), "0.1");
  EXPECT_EQ(line.summary("b", "deterministic_in_time"), "false");
  EXPECT_EQ(line.summary("a", "loss"), "");
  const std::string text = text_of(line.path() / "b" / "summary.json");
  EXPECT_GT(std::stod(text.substr(text.find("\"median\": ", text.find("exchange_seconds")) + 10)), 0.04)
      << "tick and departures are 20 ms late each";
}

TEST(LossyNetwork, BringsAKilledAgentBack) {
  if (const std::string what = forbidden(); !what.empty()) {
    GTEST_SKIP() << what << " may not be used here";
  }
  const CommandLine line;
  line.scenario("lossy.yaml",
                "    - {name: gone, type: process.kill, target: {agent: 1}, start: \"08:30\", restart_after: 30min}\n"
                "network: {loss: 0.1, delay: 20ms}\n");
  const Ended lossy = line.evbal("run lossy.yaml --transport dds --out b --quiet");
  ASSERT_EQ(lossy.status, 0) << lossy.err;
  EXPECT_EQ(line.evbal("replay b --quiet").status, 0) << "in one process";
}

TEST(LossyNetwork, NeedsABus) {
  const CommandLine line;
  line.scenario("lossy.yaml", "network: {loss: 0.1, delay: 20ms}\n");
  const Ended refused = line.evbal("run lossy.yaml --transport inproc --out b");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("choose `dds`"), std::string::npos) << refused.err;
  line.scenario("late.yaml", "network: {delay: 20min}\n");
  const Ended late = line.evbal("run late.yaml --transport dds --out b");
  EXPECT_EQ(late.status, 2);
  EXPECT_NE(late.err.find("0ms to 1s"), std::string::npos) << late.err;
}

}  // namespace
}  // namespace evbal

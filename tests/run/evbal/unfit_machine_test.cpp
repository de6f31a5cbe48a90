// What a machine lacks for a run over the bus is said before anything is waited for.

#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

/// The run does not begin, and its one line has the cure.
void expect_cure(const std::string& before, const std::string& cure) {
  const CommandLine line;
  const Ended ended = line.evbal("run morning.yaml --transport dds --quiet --out a", before);
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(ended.err.find(cure), std::string::npos) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_EQ(ended.out, "");
  const Ended doctor = line.evbal("doctor", before);
  EXPECT_NE(doctor.out.find(cure), std::string::npos) << doctor.out << doctor.err;
  EXPECT_EQ(doctor.status, 3);
}

TEST(UnfitMachine, HasNoLoopback) {
  if (std::system("unshare -rn true") != 0) {
    GTEST_SKIP() << "network namespaces may not be used here";
  }
  expect_cure("unshare -rn", "`ip link set lo up`");
}

TEST(UnfitMachine, LetsTooFewFilesBeOpened) {
  expect_cure("ulimit -n 20;", "`ulimit -n 1024`");
}

TEST(FitMachine, IsDescribedByTheDoctor) {
  const CommandLine line;
  const std::string said = line.evbal("doctor").out;
  for (const char* what : {"  ok  UDP over 127.0.0.1\n", "  ok  UDP ports of a DDS domain\n", "socket buffers of ",
                           "/dev/net/tun", " processors\n"}) {
    EXPECT_NE(said.find(what), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace evbal

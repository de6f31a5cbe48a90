#include "tests/bus/dds/run_processes.hpp"
#include "tests/bus/dds/toy_day.hpp"

#include <unistd.h>

#include <fstream>

namespace evbal {
namespace {

using RealProcessesTest = test::ToyDay;

/// KiB of memory that a process shares with no other.
int private_memory(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/smaps_rollup");
  for (std::string word; in >> word;) {
    int kib = 0;
    if (word == "Private_Dirty:" && in >> kib) {
      return kib;
    }
  }
  return 0;
}

TEST_F(RealProcessesTest, LiveTheSameDayHoweverTheyAreSpread) {
  const std::string alone = digest_over_dds(1);
  EXPECT_EQ(writers_.size(), static_cast<std::size_t>(scenario_.world.city.size()) + 1);
  EXPECT_FALSE(writers_.contains(getpid()));
  EXPECT_EQ(digest_over_dds(2), alone);
  EXPECT_EQ(digest_in_process(), alone);
}

TEST_F(RealProcessesTest, AnAgentTakesLessThanFourMegabytes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || __has_include(<fastdds/utils/IPLocator.hpp>)
  GTEST_SKIP() << "the bound is that of a Release build with Fast DDS 2";
#endif
  end_at_eleven();
  int most = 0;
  digest_over_dds(1, [&](const TickRecord& record) {
    if (record.tick.tick == 30) {
      most = private_memory(test::find_process(folder_.path(), "agent-1"));
    }
  });
  EXPECT_GT(most, 0);
  EXPECT_LT(most, 4000);
}

TEST_F(RealProcessesTest, SayWhatIsWrongWithTheirInput) {
  std::ofstream(folder_.path() / "scenario.resolved.yaml", std::ios::app) << "city: twice\n";
  try {
    digest_over_dds(5);
    FAIL() << "a broken scenario was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("status 2"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("`city` is given twice"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace evbal

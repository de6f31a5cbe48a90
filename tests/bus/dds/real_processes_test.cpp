#include "tests/bus/dds/toy_day.hpp"

#include <unistd.h>

#include <fstream>

namespace evbal {
namespace {

using RealProcessesTest = test::ToyDay;

TEST_F(RealProcessesTest, LiveTheSameDayHoweverTheyAreSpread) {
  const std::string alone = digest_over_dds(1);
  EXPECT_EQ(writers_.size(), static_cast<std::size_t>(scenario_.world.city.size()) + 1);
  EXPECT_FALSE(writers_.contains(getpid()));
  EXPECT_EQ(digest_over_dds(2), alone);
  EXPECT_EQ(digest_in_process(), alone);
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

// The shipped schedules of faults, each on the toy day.

#include "tests/run/evbal/acted.hpp"
#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> gallery() {
  const fs::directory_iterator files(EVBAL_SOURCE_DIR "/experiments/faults");
  std::vector<fs::path> schedules(begin(files), end(files));
  std::sort(schedules.begin(), schedules.end());
  return schedules;
}

class Gallery : public ::testing::TestWithParam<fs::path> {};

TEST_P(Gallery, EndsAndIsSeenToActOnTheToyDay) {
  const CommandLine line;
  const Ended ended = line.evbal("run toy.yaml --faults " + GetParam().filename().string() +
                                 " --transport inproc --engine cuts --controller robust --quiet --out a");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(line.summary("a", "fleet_conserved"), "true");
  const auto faults = read_faults(line.path() / "a" / "run.sqlite");
  EXPECT_FALSE(faults.empty());
  for (const auto& fault : faults) {
    EXPECT_EQ(acted(fault), fault.name != "never-happens") << fault.name;
  }
}

TEST_P(Gallery, IsOnItsPage) {
  const std::string page = text_of(EVBAL_SOURCE_DIR "/docs/faults-gallery.md");
  EXPECT_NE(page.find("`" + GetParam().filename().string() + "`"), std::string::npos);
  EXPECT_TRUE(text_of(GetParam()).starts_with("# ")) << "says in its first line what it shows";
}

INSTANTIATE_TEST_SUITE_P(Shipped, Gallery, ::testing::ValuesIn(gallery()), [](const auto& schedule) {
  std::string name = schedule.param.stem().string();
  std::erase(name, '-');
  return name;
});

}  // namespace
}  // namespace evbal

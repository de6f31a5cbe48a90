#include "agents/region/region_world.hpp"

#include "agents/protocol/bytes.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(RegionWorld, GoesThroughAFileUnchanged) {
  const Folder folder;
  const World world = test::world_of({.regions = 4, .stations = 2});
  const auto regions = region_worlds(world);
  write_agent_world(folder.path() / "a", world, regions, 1, 2);
  const AgentWorld read = read_agent_world(folder.path() / "a");
  ASSERT_EQ(read.regions.size(), 2U);
  EXPECT_EQ(to_bytes(read.regions[0]), to_bytes(regions[1]));
  EXPECT_EQ(to_bytes(read.regions[1]), to_bytes(regions[2]));
  EXPECT_EQ(read.bounds.regions, 4);
  EXPECT_EQ(read.bounds.longest_trip, world.city.minutes.maxCoeff());
}

TEST(RegionWorld, NamesTheFileThatIsNotThere) {
  try {
    read_agent_world("/nowhere/agent-0.world");
    FAIL() << "read";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/agent-0.world"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace evbal

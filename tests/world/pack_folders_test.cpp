#include "agents/world/world.hpp"
#include "tests/folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace evbal {
namespace {

namespace fs = std::filesystem;

TEST(PackFolders, ThatCannotBeReadArePassedOver) {
  const Folder folder;
  fs::create_symlink("loop", folder.path() / "loop");  // cannot be resolved, not even by root
  const char* before = std::getenv("EVBAL_CITIES");
  const std::string own = before == nullptr ? "" : before;
  setenv("EVBAL_CITIES", (folder.path() / "loop").c_str(), 1);
  YamlMap scenario(YamlValue::load(test::in_source("experiments/scenarios/toy.yaml")));
  EXPECT_EQ(read_world(scenario).city.size(), 5);
  setenv("EVBAL_CITIES", own.c_str(), 1);
}

}  // namespace
}  // namespace evbal


#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace evbal {
namespace {

std::ifstream open(const std::string& name) {
  std::ifstream stream(test::in_source(name));
  EXPECT_TRUE(stream) << name;
  return stream;
}

TEST(Readme, GivesAReasonForEveryPackage) {
  std::ostringstream readme;
  readme << open("README.md").rdbuf();
  auto packages = open("tools/packages.txt");
  for (std::string package; std::getline(packages, package);) {
    EXPECT_NE(readme.str().find("`" + package + "`"), std::string::npos)
        << package << " of tools/packages.txt is not in README.md's table of dependencies";
  }
}

}  // namespace
}  // namespace evbal

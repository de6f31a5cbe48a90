// Holds what every source file of the tree keeps to.

#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Sources of the tree, tests and examples too.
std::vector<fs::path> all_sources() {
  std::vector<fs::path> found;
  for (const char* top : {"agents", "common", "coordinator", "examples", "experiments", "faults", "tests", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(test::in_source(top))) {
      const auto extension = entry.path().extension();
      if (extension == ".cpp" || extension == ".hpp" || extension == ".js" || extension == ".idl") {
        found.push_back(entry.path());
      }
    }
  }
  return found;
}

TEST(Sources, AreShortEnoughToBeReadInOneGo) {
  for (const auto& file : all_sources()) {
    std::ifstream stream(file);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 350) << file;
  }
}

TEST(Sources, HeadersHaveNamesOfTheirOwn) {
  std::map<std::string, fs::path> seen;
  for (const auto& file : all_sources()) {
    if (file.extension() == ".hpp") {
      const auto [other, is_new] = seen.emplace(file.filename().string(), file);
      EXPECT_TRUE(is_new) << file << " and " << other->second;
    }
  }
}

// Two types of one name in one namespace are one to the linker, in whatever program has both.
TEST(Sources, TypesHaveNamesOfTheirOwn) {
  const std::regex type(R"(^(?:struct|class|enum class) (\w+)(?: final)?(?: : [^;]*)? \{$)");
  std::map<std::string, fs::path> seen;
  for (const auto& file : all_sources()) {
    const bool of_tests = file.string().starts_with(test::in_source("tests").string());
    std::ifstream stream(file);
    for (std::string line; file.extension() == ".hpp" && !of_tests && std::getline(stream, line);) {
      if (std::smatch found; std::regex_match(line, found, type)) {
        const auto [other, is_new] = seen.emplace(found[1], file);
        EXPECT_TRUE(is_new) << found[1] << ": " << file << " and " << other->second;
      }
    }
  }
}

// Headers of rooms are installed, and Eigen's alignment is checked wherever a user's program meets them.
TEST(Sources, HeadersIncludeEigenWithTheCheckOfItsAlignment) {
  for (const auto& file : all_sources()) {
    const bool of_tests = file.string().starts_with(test::in_source("tests").string());
    if (file.extension() == ".hpp" && !of_tests && file != test::in_source("common/eigen.hpp")) {
      std::ifstream stream(file);
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      const auto has = [&text](const char* include) { return text.find(include) != std::string::npos; };
      EXPECT_FALSE(has("#include <Eigen/") && !has("#include \"common/eigen.hpp\""))
          << file << ": include common/eigen.hpp";
    }
  }
}

}  // namespace
}  // namespace evbal

// The page of answers that a sweep leaves: its verdict, its figures, and that all of it comes out again.

#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

const std::string small_page = "sweep page-small.yaml --quick --quiet --jobs 2 --out s";

/// The files that tell what came out of the sweep, by their path in its folder.
std::map<std::string, std::string> told(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::path& file : fs::recursive_directory_iterator(folder)) {
    if (const std::string suffix = file.extension(); suffix == ".md" || suffix == ".svg" || suffix == ".csv") {
      files[file.lexically_relative(folder)] = text_of(file);
    }
  }
  return files;
}

TEST(StudyPage, ComesOutAgainToTheByteFromTheStoredDays) {
  const CommandLine line;
  ASSERT_EQ(line.evbal(small_page).status, 0);
  const fs::path folder = line.path() / "s";
  const auto first = told(folder);
  EXPECT_EQ(first.size(), 9U) << "page, days, steps and six figures";
  const std::string& page = first.at("page.md");
  for (const auto& [name, text] : first) {
    if (name.ends_with(".svg")) {
      EXPECT_NE(page.find("](" + name + ")"), std::string::npos) << name << " is not on the page";
    }
  }
  for (const auto& [name, text] : first) {
    fs::remove(folder / name);
  }
  const Ended plan = line.evbal("sweep page-small.yaml --quick --out s --dry-run");
  EXPECT_NE(plan.out.find(" 0 left"), std::string::npos) << plan.out;
  ASSERT_EQ(line.evbal(small_page).status, 0);
  EXPECT_TRUE(told(folder) == first);
}

TEST(StudyPage, DrawsFiguresThatStandByThemselves) {
  const CommandLine line;
  ASSERT_EQ(line.evbal(small_page).status, 0);
  int drawn = 0;
  for (const auto& [name, text] : told(line.path() / "s")) {
    if (!name.ends_with(".svg")) {
      continue;
    }
    ++drawn;
    EXPECT_TRUE(text.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"")) << name;
    for (const char* part : {"<title>", "<desc>", "fill=\"#ffffff\"", "font:600 "}) {
      EXPECT_NE(text.find(part), std::string::npos) << name << " has no " << part;
    }
    for (const char* part : {"NaN", "undefined", "Infinity", "var(", "class=", "null", "<script"}) {
      EXPECT_EQ(text.find(part), std::string::npos) << name << " has " << part;
    }
    const std::regex far("=\"-?[0-9]+\\.[0-9]{2}[0-9]*\"");
    EXPECT_FALSE(std::regex_search(text, far)) << name << ": coordinates are to the tenth";
  }
  EXPECT_EQ(drawn, 6);
  const std::string page = text_of(line.path() / "s/page.md");
  EXPECT_EQ(page.find("inf .."), std::string::npos);
}

TEST(StudyPage, IsWrittenWithoutFiguresWhereNothingDrawsThem) {
  const CommandLine line;
  ASSERT_EQ(line.evbal(small_page).status, 0);
  const fs::path folder = line.path() / "s";
  const auto whole = told(folder);
  const Ended without = line.evbal(small_page, "PATH=/nowhere");
  EXPECT_EQ(without.status, 0) << without.err;
  EXPECT_NE(without.err.find("the packages nodejs and node-jsdom"), std::string::npos) << without.err;
  EXPECT_NE(without.err.find("`evbal report s --figures` draws them"), std::string::npos) << without.err;
  EXPECT_EQ(told(folder).size(), 3U);
  EXPECT_EQ(line.evbal("report s --figures", "PATH=/nowhere").status, 3);
  const Ended later = line.evbal("report s --figures");
  EXPECT_EQ(later.status, 0) << later.err;
  EXPECT_EQ(later.out, "s/figures\n");
  EXPECT_TRUE(told(folder) == whole);
  EXPECT_EQ(line.evbal("report s s --figures").status, 2);
}

TEST(StudyPage, ShowsTheBoundOnceEachDayHasOne) {
  const CommandLine line;
  const std::string scenario = text_of(EVBAL_SOURCE_DIR "/experiments/scenarios/toy.yaml");
  std::ofstream(line.path() / "calm.yaml") << scenario.substr(0, scenario.find("\nfaults:") + 1);
  ASSERT_EQ(line.evbal("bound calm.yaml --prices 10 --quiet --day 2024-01-09").status, 0);
  ASSERT_EQ(line.evbal(small_page).status, 0);
  const fs::path folder = line.path() / "s";
  EXPECT_NE(text_of(folder / "figures/1-fronts.svg").find("Bound of 1 of 2 days only: not drawn."), std::string::npos);
  EXPECT_NE(text_of(folder / "page.md").find("the bound is of 1 of"), std::string::npos);
  ASSERT_EQ(line.evbal("bound calm.yaml --prices 10 --quiet --day 2024-01-10").status, 0);
  ASSERT_EQ(line.evbal(small_page).status, 0);
  EXPECT_NE(text_of(folder / "figures/1-fronts.svg").find(">bound: no planner can be below"), std::string::npos);
  EXPECT_NE(text_of(folder / "page.md").find("below which no planner can be"), std::string::npos);
}

}  // namespace
}  // namespace evbal

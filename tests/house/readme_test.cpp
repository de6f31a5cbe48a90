// Holds what the pages for readers say of the tree against the tree.

#include "common/version.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  EXPECT_TRUE(stream) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// What stands between the heading `title` and the next one of its level or above.
std::string section(const std::string& page, const std::string& title) {
  const auto begin = page.find("\n## " + title + "\n");
  EXPECT_NE(begin, std::string::npos) << title;
  return page.substr(begin, page.find("\n## ", begin + 1) - begin);
}

/// The first group of every match.
std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex); at != std::sregex_iterator(); ++at) {
    found.push_back((*at)[1]);
  }
  return found;
}

/// Markdown files that this project wrote for readers.
std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  for (const char* folder : {"", "docs"}) {
    for (const auto& entry : fs::directory_iterator(test::in_source(folder))) {
      if (entry.path().extension() == ".md") {
        found.push_back(entry.path());
      }
    }
  }
  return found;
}

/// The names by which links reach a page's headings: small letters, blanks as hyphens, no punctuation.
std::set<std::string> anchors_of(const fs::path& page) {
  std::set<std::string> anchors;
  for (const std::string& heading : all_matches(text_of(page), "(?:^|\n)#+ ([^\n]*)")) {
    std::string anchor;
    for (const char letter : heading) {
      if (std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' || letter == '_' || letter == ' ') {
        anchor += letter == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
      }
    }
    anchors.insert(anchor);
  }
  return anchors;
}

using Names = std::vector<std::string>;

/// The packages of the README's table that stands below the link to `list`, sorted.
Names packages_with_a_reason(const std::string& list) {
  const std::string dependencies = section(text_of(test::in_source("README.md")), "Dependencies");
  const auto link = dependencies.find("](" + list + ")");
  EXPECT_NE(link, std::string::npos) << list;
  Names given;
  bool in_table = false;
  for (const std::string& row : lines_of(dependencies.substr(link))) {
    if (in_table && !row.starts_with("|")) {
      break;
    }
    in_table = in_table || row.starts_with("|");
    if (row.starts_with("| `")) {
      const Names packages = all_matches(row.substr(0, row.find('|', 1)), "`([^`]+)`");
      given.insert(given.end(), packages.begin(), packages.end());
    }
  }
  std::sort(given.begin(), given.end());
  return given;
}

TEST(Readme, GivesAReasonForEveryPackageAndNoOther) {
  for (const char* list : {"tools/packages-run.txt", "tools/packages-deb.txt", "tools/packages-test.txt"}) {
    EXPECT_EQ(packages_with_a_reason(list), lines_of(text_of(test::in_source(list)))) << list;
  }
}

TEST(Packages, OfTestsAreNotInstalledToRunADay) {
  const Names to_run = lines_of(text_of(test::in_source("tools/packages-run.txt")));
  const Names to_test = lines_of(text_of(test::in_source("tools/packages-test.txt")));
  Names both;
  std::set_intersection(to_run.begin(), to_run.end(), to_test.begin(), to_test.end(), std::back_inserter(both));
  EXPECT_EQ(both, Names{});
  for (const char* heavy : {"chromium", "clang-tidy", "default-jre-headless", "qemu-user", "slurmctld", "slurmd"}) {
    EXPECT_FALSE(std::binary_search(to_run.begin(), to_run.end(), heavy)) << heavy;
  }
}

TEST(Readme, NamesFoldersAndFilesThatExist) {
  const std::string where = section(text_of(test::in_source("README.md")), "What lies where");
  fs::path top;
  int folders = 0;
  for (const std::string& line : lines_of(where)) {
    if (!line.starts_with("    ")) {
      continue;
    }
    const bool below = line[4] == ' ';
    const std::string names = line.substr(4, line.find("    ", below ? 6 : 4) - 4);  // a remark stands to the right
    for (const std::string& folder : all_matches(names, "([a-z_/]+)/(?= |$)")) {
      const fs::path path = below ? top / folder : fs::path(folder);
      EXPECT_TRUE(fs::is_directory(test::in_source(path.string()))) << line;
      top = below ? top : path;
      ++folders;
    }
  }
  EXPECT_GT(folders, 30);
  for (const std::string& file : all_matches(where, "`([a-z_/]+\\.[a-z]+)`")) {
    EXPECT_TRUE(fs::is_regular_file(test::in_source(file))) << file;
  }
}

TEST(Pages, AreAllLinkedFromTheirList) {
  const std::string list = text_of(test::in_source("docs/README.md"));
  for (const auto& entry : fs::directory_iterator(test::in_source("docs"))) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".md" && name != "README.md") {
      EXPECT_NE(list.find("](" + name + ")"), std::string::npos) << name << " is not linked from docs/README.md";
    }
  }
}

TEST(Pages, LinkToPagesAndHeadingsThatExist) {
  const std::regex link("\\]\\(([^)#: ]*)(?:#([^)]*))?\\)");
  for (const auto& page : pages()) {
    const std::string text = text_of(page);
    for (std::sregex_iterator at(text.begin(), text.end(), link); at != std::sregex_iterator(); ++at) {
      const std::string anchor = (*at)[2];
      const fs::path target = (*at)[1].length() == 0 ? page : page.parent_path() / (*at)[1].str();
      EXPECT_TRUE(fs::exists(target)) << page << ": " << at->str();
      EXPECT_TRUE(anchor.empty() || anchors_of(target).contains(anchor)) << page << ": " << at->str();
    }
  }
}

TEST(Version, IsTheSameWhereverItStands) {
  const std::string number = "([0-9]+\\.[0-9]+\\.[0-9]+)";
  const auto first = [&](const std::string& file, const std::string& before) {
    const auto found = all_matches(text_of(test::in_source(file)), before + number);
    return found.empty() ? file + " has none" : found.front();
  };
  EXPECT_EQ(first("CMakeLists.txt", "project\\(evbal VERSION "), version());
  EXPECT_EQ(first("CITATION.cff", "\nversion: "), version());
  EXPECT_EQ(first("CHANGELOG.md", "\n## \\["), version());
}

}  // namespace
}  // namespace evbal

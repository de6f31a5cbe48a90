// Holds the include arrows of arrows.hpp.

#include "tests/house/arrows.hpp"

#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

using house::Ban;
using house::bans;
using house::Reserved;
using house::reserved;
using house::Room;
using house::rooms;
using house::Words;

const fs::path& root() {
  static const fs::path path = test::in_source("");
  return path;
}

bool contains(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

const Room* find_room(const std::string& folder) {
  const auto at = std::find_if(rooms().begin(), rooms().end(), [&](const Room& r) { return r.folder == folder; });
  return at == rooms().end() ? nullptr : &*at;
}

struct Include {
  std::string file;  ///< that includes, from the root
  std::string room;  ///< folder of `file`
  int line = 0;
  std::string name;  ///< what is included
  bool quoted = false;

  std::string place() const { return file + ":" + std::to_string(line) + ": " + name; }
};

void read_includes(const fs::path& file, std::vector<Include>& found) {
  const std::string name = file.lexically_relative(root()).generic_string();
  const std::string room = fs::path(name).parent_path().generic_string();
  std::ifstream stream(file);
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line) {
    constexpr std::string_view directive = "#include ";
    if (!text.starts_with(directive) || text.size() < directive.size() + 2) {
      continue;
    }
    const bool quoted = text[directive.size()] == '"';
    const std::size_t begin = directive.size() + 1;
    found.push_back({name, room, line, text.substr(begin, text.find(quoted ? '"' : '>', begin) - begin), quoted});
  }
}

std::vector<Include> all_includes() {
  std::vector<Include> found;
  for (const char* top : {"agents", "common", "coordinator", "experiments", "faults", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root() / top)) {
      const auto extension = entry.path().extension();
      if (extension == ".cpp" || extension == ".hpp") {
        read_includes(entry.path(), found);
      }
    }
  }
  return found;
}

using Complaints = std::vector<std::string>;

Complaints wrong_rows(const std::vector<Room>& table) {
  Complaints wrong;
  Words above;
  for (const Room& room : table) {
    for (const std::string& known : room.knows) {
      if (!contains(above, known)) {
        wrong.push_back(room.folder + " knows " + known + ", which does not lie below it");
      }
    }
    above.push_back(room.folder);
  }
  return wrong;
}

Complaints wrong_includes(const std::vector<Include>& includes) {
  Complaints wrong;
  for (const Include& include : includes) {
    const Room* room = find_room(include.room);
    if (room == nullptr) {
      wrong.push_back(include.place() + ": " + include.room + " is no room of the table in this test");
    } else if (include.quoted && !fs::exists(root() / include.name)) {
      wrong.push_back(include.place() + ": is not in the tree");
    } else if (include.quoted) {
      const std::string known = fs::path(include.name).parent_path().generic_string();
      if (known != include.room && !contains(room->knows, known)) {
        wrong.push_back(include.place() + ": " + include.room + " may not know " + known);
      }
    }
  }
  return wrong;
}

Complaints unused_arrows(const std::vector<Include>& includes) {
  Complaints wrong;
  for (const Room& room : rooms()) {
    for (const std::string& known : room.knows) {
      const bool used = std::any_of(includes.begin(), includes.end(), [&](const Include& include) {
        return include.quoted && include.room == room.folder &&
               fs::path(include.name).parent_path().generic_string() == known;
      });
      if (!used) {
        wrong.push_back(room.folder + " includes nothing of " + known + "; strike it from the table");
      }
    }
  }
  return wrong;
}

Complaints misplaced_names(const std::vector<Include>& includes) {
  Complaints wrong;
  for (const Include& include : includes) {
    for (const Reserved& rule : reserved()) {
      if (include.name.starts_with(rule.include) && !contains(rule.rooms, include.room)) {
        wrong.push_back(include.place() + ": is reserved to " + rule.rooms.front());
      }
    }
    for (const Ban& ban : bans()) {
      if (include.room == ban.folder && contains(ban.includes, include.name)) {
        wrong.push_back(include.place() + ": " + ban.folder + " knows no clock, no file, no thread");
      }
    }
    // They compile for ten seconds each.
    const bool heavy = include.name.starts_with("CLI/") || include.name == "nlohmann/json.hpp";
    if (heavy && include.file.ends_with(".hpp")) {
      wrong.push_back(include.place() + ": stays out of headers");
    }
  }
  return wrong;
}

std::string source_text(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Folders whose CMakeLists.txt name the library.
std::set<std::string> folders_that_link(const std::string& library) {
  std::set<std::string> folders;
  for (const char* top : {"agents", "coordinator", "experiments", "faults", "tests", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root() / top)) {
      if (entry.path().filename() == "CMakeLists.txt" &&
          std::regex_search(source_text(entry.path()), std::regex(library + "\\b"))) {
        folders.insert(entry.path().parent_path().lexically_relative(root()).generic_string());
      }
    }
  }
  return folders;
}

const Complaints none;

TEST(Arrows, TableRunsDownhill) {
  EXPECT_EQ(wrong_rows(rooms()), none);
}

TEST(Arrows, RoomsKnowOnlyWhatTheyMay) {
  const auto includes = all_includes();
  ASSERT_FALSE(includes.empty());
  EXPECT_EQ(wrong_includes(includes), none);
}

TEST(Arrows, RoomsMayOnlyKnowWhatTheyUse) {
  EXPECT_EQ(unused_arrows(all_includes()), none);
}

TEST(Arrows, ThirdPartyNamesStayInTheirRooms) {
  EXPECT_EQ(misplaced_names(all_includes()), none);
}

TEST(Arrows, PlantIsLinkedByAgentsInprocessPlayersAndTests) {
  EXPECT_EQ(folders_that_link("evbal::region"), (std::set<std::string>{"agents", "experiments/conductor", "tests"}));
}

TEST(Arrows, PlantedViolationsAreFound) {
  const std::vector<Include> planted = {
      {"coordinator/convex/engine.hpp", "coordinator/convex", 1, "agents/world/city.hpp", true},
      {"coordinator/planning/settings.hpp", "coordinator/planning", 1, "agents/region/region_plant.hpp", true},
      {"experiments/record/csv.cpp", "experiments/record", 1, "experiments/conductor/run_day.hpp", true},
      {"experiments/study/store/sweep_file.cpp", "experiments/study/store", 1, "tools/report/report.hpp", true},
      {"agents/lobby/door.hpp", "agents/lobby", 1, "common/error.hpp", true},
  };
  for (const Include& include : planted) {
    EXPECT_EQ(wrong_includes({include}).size(), 1U) << include.place();
  }
  const std::vector<Include> misplaced = {
      {"agents/hosting/roles.cpp", "agents/hosting", 1, "fastdds/dds/core/status/StatusMask.hpp", false},
      {"coordinator/balancing/arcs.cpp", "coordinator/balancing", 1, "chrono", false},
      {"experiments/run/twins.hpp", "experiments/run", 1, "nlohmann/json.hpp", false},
  };
  for (const Include& include : misplaced) {
    EXPECT_EQ(misplaced_names({include}).size(), 1U) << include.place();
  }
  EXPECT_EQ(wrong_rows({{"common", {"agents"}}, {"agents", {}}}).size(), 1U);
  EXPECT_FALSE(unused_arrows({}).empty());
}

}  // namespace
}  // namespace evbal

// Holds the include arrows of docs/architecture.md: who may know whom, downhill only.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

struct Room {
  std::string folder;
  Words knows;  ///< rooms above it in the table, besides itself
};

// A program's `main` lies in the folder above its libraries, so "agents" is the room of evbal-agent alone.
const std::vector<Room>& rooms() {
  static const std::vector<Room> table = {
      {"common", {}},
      {"agents/protocol", {"common"}},
      {"agents/city", {"common"}},
      {"agents/region", {"common", "agents/protocol", "agents/city"}},
      {"agents/bus", {"common", "agents/protocol"}},
      {"coordinator/forecast", {"common", "agents/city"}},
      {"coordinator/ambiguity", {"common", "agents/city", "coordinator/forecast"}},
      {"coordinator/balancing", {"common", "agents/city", "coordinator/forecast", "coordinator/ambiguity"}},
      {"coordinator/planning",
       {"common", "agents/protocol", "agents/city", "coordinator/forecast", "coordinator/ambiguity",
        "coordinator/balancing"}},
      {"faults/schedule", {"common", "agents/protocol"}},

      {"agents", {"common", "agents/protocol", "agents/city", "agents/region", "agents/bus"}},
      // faults: for the `oracle` alone, which is told the future
      {"coordinator/serving",
       {"common", "agents/protocol", "agents/city", "agents/region", "agents/bus", "coordinator/balancing",
        "coordinator/planning", "faults/schedule"}},
      {"coordinator/bridge",
       {"common", "agents/protocol", "agents/city", "agents/region", "agents/bus", "coordinator/balancing",
        "coordinator/planning"}},
      {"coordinator", {"coordinator/serving", "coordinator/bridge"}},
      {"faults", {"common", "agents/protocol", "agents/city", "agents/region", "agents/bus", "faults/schedule"}},

      {"experiments/scenario",
       {"common", "agents/protocol", "agents/city", "agents/region", "coordinator/balancing", "coordinator/planning",
        "faults/schedule"}},
      {"experiments/conductor",
       {"common", "agents/protocol", "agents/city", "agents/region", "agents/bus", "coordinator/planning",
        "faults/schedule", "experiments/scenario"}},
      {"experiments/progress", {"common", "agents/protocol", "agents/city", "agents/region", "experiments/conductor"}},
      {"experiments/metrics",
       {"common", "agents/protocol", "agents/city", "agents/region", "experiments/scenario", "experiments/conductor"}},
      {"experiments/record",
       {"common", "agents/protocol", "agents/city", "agents/region", "coordinator/planning", "faults/schedule",
        "experiments/scenario", "experiments/conductor", "experiments/metrics"}},
      {"experiments/sweep",
       {"common", "agents/protocol", "agents/city", "agents/region", "coordinator/balancing", "coordinator/planning",
        "faults/schedule", "experiments/scenario", "experiments/conductor", "experiments/metrics",
        "experiments/record"}},
      {"tools/records", {"common", "agents/city"}},
      {"tools/fit",
       {"common", "agents/protocol", "agents/city", "agents/region", "coordinator/forecast", "coordinator/ambiguity",
        "coordinator/balancing", "coordinator/planning", "faults/schedule", "experiments/scenario",
        "experiments/conductor", "experiments/metrics"}},
      {"tools/gps", {"common", "agents/city", "tools/records", "tools/fit"}},
      {"tools/ingest", {"common", "agents/city", "tools/records", "tools/gps"}},
      {"tools/report",
       {"common", "agents/protocol", "agents/city", "agents/region", "coordinator/ambiguity", "coordinator/forecast",
        "experiments/scenario", "experiments/metrics", "experiments/record", "experiments/sweep"}},
      {"tools/samples", {"common", "coordinator/ambiguity", "coordinator/balancing"}},
      {"tools/verify",
       {"common", "agents/region", "coordinator/forecast", "coordinator/ambiguity", "coordinator/balancing",
        "coordinator/planning", "tools/samples"}},
      {"tools/bench", {"common", "coordinator/ambiguity", "coordinator/balancing", "tools/samples", "tools/verify"}},
      {"experiments/commands",
       {"common", "agents/protocol", "agents/city", "agents/region", "coordinator/planning", "faults/schedule",
        "experiments/scenario", "experiments/conductor", "experiments/progress", "experiments/metrics",
        "experiments/record", "experiments/sweep", "tools/report"}},
      {"experiments", {"common", "agents/region", "experiments/commands", "tools/ingest", "tools/fit", "tools/verify"}},
  };
  return table;
}

struct Reserved {
  std::string include;  ///< beginning of what stands between the quotes or angle brackets
  Words rooms;          ///< the rooms that may include it
};

// Third-party names that stay in one place.
const std::vector<Reserved>& reserved() {
  static const std::vector<Reserved> table = {
      {"fastdds/", {"agents/bus"}},
      {"fastrtps/", {"agents/bus"}},
      {"fastcdr/", {"agents/bus"}},
      {"IpTNLP", {"coordinator/balancing"}},
      {"IpIpopt", {"coordinator/balancing"}},
      {"yaml-cpp/", {"common"}},
      {"Random123/", {"common"}},
      {"nlopt", {"coordinator/forecast"}},
      {"SQLiteCpp/", {"experiments/record", "experiments/sweep"}},
  };
  return table;
}

struct Ban {
  std::string folder;
  Words includes;
};

// The problem is mathematics: values in, values out.
const std::vector<Ban>& bans() {
  static const std::vector<Ban> table = {
      {"coordinator/balancing", {"common/clock.hpp", "common/yaml.hpp", "chrono", "filesystem", "fstream", "thread"}},
  };
  return table;
}

const fs::path& root() {
  static const fs::path path = EVBAL_SOURCE_DIR;
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

TEST(Arrows, TableRunsDownhill) {
  Words above;
  for (const Room& room : rooms()) {
    for (const std::string& known : room.knows) {
      EXPECT_TRUE(contains(above, known)) << room.folder << " knows " << known << ", which does not lie below it";
    }
    above.push_back(room.folder);
  }
}

TEST(Arrows, RoomsKnowOnlyWhatTheyMay) {
  const auto includes = all_includes();
  ASSERT_FALSE(includes.empty());
  for (const Include& include : includes) {
    const Room* room = find_room(include.room);
    if (room == nullptr) {
      ADD_FAILURE() << include.place() << "\n" << include.room << " is no room of the table in this test";
      continue;
    }
    if (!include.quoted) {
      continue;
    }
    if (!fs::exists(root() / include.name)) {
      EXPECT_EQ(include.room, "agents/bus") << include.place() << "\nis not in the tree (only the bus has generated "
                                            << "headers); includes start at the tree's root";
      continue;
    }
    const std::string known = fs::path(include.name).parent_path().generic_string();
    EXPECT_TRUE(known == include.room || contains(room->knows, known)) << include.place() << "\n"
                                                                       << include.room << " may not know " << known;
  }
}

TEST(Arrows, ThirdPartyNamesStayInTheirRooms) {
  for (const Include& include : all_includes()) {
    for (const Reserved& rule : reserved()) {
      if (include.name.starts_with(rule.include)) {
        EXPECT_TRUE(contains(rule.rooms, include.room)) << include.place() << "\nis reserved to " << rule.rooms.front();
      }
    }
    for (const Ban& ban : bans()) {
      EXPECT_FALSE(include.room == ban.folder && contains(ban.includes, include.name))
          << include.place() << "\n"
          << ban.folder << " knows no clock, no file, no thread";
    }
  }
}

// They compile for ten seconds each.
TEST(Arrows, HeavyHeadersStayOutOfHeaders) {
  for (const Include& include : all_includes()) {
    if (include.file.ends_with(".hpp")) {
      EXPECT_FALSE(include.name.starts_with("CLI/") || include.name == "nlohmann/json.hpp") << include.place();
    }
  }
}

}  // namespace
}  // namespace evbal

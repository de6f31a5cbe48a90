#include "tools/evbal/sourced_scenario.hpp"

#include "tests/folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <map>

namespace evbal {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> sources_of(const fs::path& file, const Overrides& overrides = {}) {
  const SourcedScenario scenario = sourced_scenario(file, overrides);
  return {scenario.sources.begin(), scenario.sources.end()};
}

TEST(SourcedScenario, SaysWhereEachValueComesFrom) {
  const Folder folder;
  const fs::path file = folder.write("a.yaml",
                                     "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 1\nclock:\n  end: \"10:00\"\n"
                                     "fleet: {vehicles: 30}\ncontrollers: [nominal, robust]\n");
  auto sources = sources_of(file, {.engine = "cuts", .settings = {"balancing.tau=1", "fleet.vehicles=40"}});
  EXPECT_EQ(sources["name"], "the file's name");
  EXPECT_EQ(sources["city"], "a.yaml:2");
  EXPECT_EQ(sources["clock.end"], "a.yaml:6");
  EXPECT_EQ(sources["clock.start"], "the city's pack");
  EXPECT_EQ(sources["clock.tick"], "default");
  EXPECT_EQ(sources["fleet.vehicles"], "--set");
  EXPECT_EQ(sources["fleet.battery_kwh"], "the city's pack");
  EXPECT_EQ(sources["stations"], "the city's pack");
  EXPECT_EQ(sources["controllers"], "a.yaml:8");
  EXPECT_EQ(sources["engine"], "--engine");
  EXPECT_EQ(sources["balancing.tau"], "--set");
  EXPECT_EQ(sources["balancing.eta"], "default");
  EXPECT_EQ(sources["faults.faults"], "default");
  EXPECT_EQ(sources_of(file, {.controller = "ratio"})["controller"], "--controller");
}

TEST(SourcedScenario, KnowsDrawnFaults) {
  const fs::path toy = test::in_source("experiments/scenarios/toy.yaml");
  const fs::path stadium = test::in_source("experiments/faults/stadium.yaml");
  EXPECT_EQ(sources_of(toy)["faults.faults"].find("drawn from toy.yaml:"), 0U);
  EXPECT_EQ(sources_of(toy, {.faults = stadium})["faults.faults"].find("drawn from stadium.yaml:"), 0U);
}

TEST(SourcedScenario, IsAScenarioAgain) {
  const Folder folder;
  for (const auto& entry : fs::directory_iterator(test::in_source("experiments/scenarios"))) {
    const Scenario scenario = read_scenario(entry.path());
    const Scenario again = read_scenario(folder.write("again.yaml", sourced_scenario(entry.path(), {}).text));
    EXPECT_EQ(again.controllers, scenario.controllers);
    EXPECT_EQ(resolved_yaml(again, "robust"), resolved_yaml(scenario, "robust")) << entry.path();
  }
}

TEST(SourcedScenario, QuotesWhatYamlWouldTakeForSomethingElse) {
  const Folder folder;
  const std::string name = "a \"b\" \\c: #1, {d}";
  const fs::path file =
      folder.write("a.yaml",
                   "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 1\n"
                   "name: \"a \\\"b\\\" \\\\c: #1, {d}\"\n"
                   "stations: [{name: \"null\", region: 0, points: 1}, {name: \"a, b: c\", region: 1, points: 2}]\n");
  const Scenario again = read_scenario(folder.write("again.yaml", sourced_scenario(file, {}).text));
  EXPECT_EQ(again.name, name);
  EXPECT_EQ(again.world.city.stations.at(0).name, "null");
  EXPECT_EQ(again.world.city.stations.at(1).name, "a, b: c");
}

}  // namespace
}  // namespace evbal

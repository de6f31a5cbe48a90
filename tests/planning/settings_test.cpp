#include "coordinator/planning/settings.hpp"

#include "tests/folder.hpp"
#include "tests/support/yaml_of.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

PlanningSettings settings_of(const std::string& text) {
  YamlMap map(YamlValue::parse(text, "/runs/a.yaml"));
  PlanningSettings settings = read_planning(map);
  map.finish();
  return settings;
}

std::string planning_yaml(const PlanningSettings& settings) {
  return yaml_of([&](YamlWriter& yaml) { write_planning(yaml, settings); });
}

TEST(Planning, ReadsWhatItIsGiven) {
  const PlanningSettings settings =
      settings_of("controller: nominal\niterations: 50\nmodel: sub/m.json\nbalancing: {a: 0.5, tau: 3}\n");
  EXPECT_EQ(settings.controller, "nominal");
  EXPECT_EQ(settings.engine.max_iterations, 50);
  EXPECT_EQ(settings.model, "/runs/sub/m.json");
  EXPECT_EQ(settings.balancing.a, 0.5);
  EXPECT_EQ(settings.balancing.tau, 3);
  EXPECT_EQ(settings.balancing.beta, BalancingParameters{}.beta);
}

TEST(Planning, GivesItselfBackAsYaml) {
  PlanningSettings settings;
  settings.controller = "greedy";
  settings.engine.max_iterations = 77;
  settings.model = "/a \"b\"/model.json";
  settings.innovation_test = true;
  settings.sensor_faults = SensorFaults::isolate;
  settings.balancing = {0.11, 1.0 / 3.0,      2.0,  0.9, 8.0, 7.0, 6.0,  5.0, 11.0, 0.4, 9.0, 3.0, 4, 5,
                        2.5,  Supply::points, 50.0, 15,  4,   2,   21.0, 9,   0.6,  7.0, 0.8, 1.5};
  const std::string text = planning_yaml(settings);
  const PlanningSettings back = settings_of(text);
  EXPECT_EQ(back.model, settings.model);
  EXPECT_TRUE(back.innovation_test);
  EXPECT_EQ(back.sensor_faults, SensorFaults::isolate);
  EXPECT_EQ(back.balancing.theta_0, settings.balancing.theta_0);
  EXPECT_EQ(back.balancing.supply, Supply::points);
  EXPECT_EQ(back.balancing.flow_slot, 15);
  EXPECT_EQ(back.balancing.flow_served, 0.8);
  EXPECT_EQ(planning_yaml(back), text);
  EXPECT_EQ(planning_yaml(settings_of(planning_yaml({}))), planning_yaml({}));
}

TEST(Planning, RefusesWhatIsWrong) {
  for (const char* wrong : {"controller: robsut\n", "engine: magic\n", "iterations: 0\n", "balancing: {tau: 0}\n",
                            "balancing: {eta: 1.5}\n", "balancing: {thta: 1}\n", "balancing: {supply: point}\n",
                            "balancing: 3\n", "sensor_faults: find\n"}) {
    EXPECT_THROW(settings_of(wrong), Error) << wrong;
  }
}

TEST(Planning, ReadsTheCoordinatorsCommand) {
  const Folder folder;
  folder.write("mine.py", "");
  YamlMap map(YamlValue::parse("coordinator: [bridge, -v, mine.py, ./x]\ncontroller: mine\n",
                               (folder.path() / "a.yaml").string()));
  const PlanningSettings settings = read_planning(map);
  EXPECT_EQ(settings.coordinator, (Command{"bridge", "-v", (folder.path() / "mine.py").string(), "./x"}))
      << "words that name files alone have a place";
  EXPECT_EQ(settings.controller, "mine");
  EXPECT_EQ(settings_of(planning_yaml(settings)).coordinator, settings.coordinator);
  EXPECT_EQ(command_from("/here", {"sub/../bin/mine"}), Command{"/here/bin/mine"});
  EXPECT_THROW(settings_of("controller: mine\ncoordinator: []\n"), Error);
  EXPECT_THROW(settings_of("controller: mi/ne\ncoordinator: [bridge]\n"), Error);
  EXPECT_THROW(settings_of("coordinator: bridge\n"), Error);
}

TEST(Planning, KeepsTheParametersOfACoordinator) {
  const std::string given = "parameters: {reach: 3, share: 0.5, mode: near, bold: true}\n";
  const PlanningSettings settings = settings_of("coordinator: [mine]\ncontroller: own\n" + given);
  EXPECT_EQ(std::get<double>(settings.parameters.at("reach")), 3.0);
  EXPECT_EQ(std::get<double>(settings.parameters.at("share")), 0.5);
  EXPECT_EQ(std::get<std::string>(settings.parameters.at("mode")), "near");
  EXPECT_EQ(std::get<bool>(settings.parameters.at("bold")), true);
  EXPECT_EQ(settings_of(planning_yaml(settings)).parameters, settings.parameters);
  EXPECT_THROW(settings_of(given), Error) << "of evbal's own controllers";
  EXPECT_THROW(settings_of("coordinator: [mine]\ncontroller: own\nparameters: {a: [1]}\n"), Error);
  EXPECT_THROW(settings_of("coordinator: [mine]\ncontroller: own\nparameters: {a b: 1}\n"), Error);
  YamlMap map(YamlValue::parse(given, "a.yaml"));
  EXPECT_TRUE(read_planning(map, Command{}).parameters.empty()) << "of a scenario whose coordinator is not used";
}

TEST(Planning, FindsTheCitysOwnModel) {
  City city;
  city.folder = "/cities/x";
  EXPECT_EQ(model_file(settings_of("model: pack\n"), city), "/cities/x/model.json");
  EXPECT_EQ(model_file({}, city), "/cities/x/model.json");
}

}  // namespace
}  // namespace evbal

#include "experiments/scenario/scenario.hpp"

#include "experiments/metrics/metrics.hpp"
#include "tests/scenario/scenario_file.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace evbal {
namespace {

namespace fs = std::filesystem;

using test::head;
using test::ScenarioFile;

const fs::path shipped = test::in_source("experiments/scenarios");

TEST_F(ScenarioFile, NeedsNoMoreThanAWorld) {
  const Scenario scenario = read_scenario(write(head));
  EXPECT_EQ(scenario.name, "a");
  EXPECT_EQ(scenario.world.city.size(), 5);
  EXPECT_EQ(scenario.world.seed, 1U);
  EXPECT_EQ(scenario.controllers, (std::vector<std::string>{"robust"}));
  EXPECT_EQ(scenario.transport, "dds");
  EXPECT_EQ(scenario.regions_per_process, 1);
  EXPECT_TRUE(scenario.schedule.faults.empty());
  EXPECT_TRUE(scenario.expect.empty());
}

TEST_F(ScenarioFile, LetsAnAgentHostSeveralRegionsWhereThereWouldBeTooManyAgents) {
  const std::string large =
      "schema: 1\ncity: shenzhen-491\nday: " + find_city("shenzhen-491").days.front() + "\nseed: 1\n";
  EXPECT_EQ(read_scenario(write(large)).regions_per_process, 5);
  EXPECT_EQ(read_scenario(write(large + "regions_per_process: 1\n")).regions_per_process, 1);
  EXPECT_EQ(usual_regions_per_process(1), 1);
  EXPECT_EQ(usual_regions_per_process(100), 1);
  EXPECT_EQ(usual_regions_per_process(101), 2);
}

TEST_F(ScenarioFile, RefusesWhatIsWrong) {
  struct Case {
    std::string more;
    int line;
    std::string hint;
  };
  for (const auto& wrong : std::vector<Case>{
           {"transprot: dds\n", 5, "did you mean `transport`"},
           {"name: ../x\n", 5, "`/`"},
           {"name: a/b\n", 5, "`/`"},
           {"name: ..\n", 5, "begin with `.`"},
           {"name: \"\"\n", 5, "bytes"},
           {"name: " + std::string(101, 'x') + "\n", 5, "bytes"},
           {"name: \"a\\nb\"\n", 5, "line break"},
           {"name: \"a\xff\"\n", 5, "UTF-8"},
           {"transport: udp\n", 5, "choose one of `dds`, `inproc`"},
           {"regions_per_process: 0\n", 5, "from 1"},
           {"controller: robst\n", 5, "did you mean `robust`"},
           {"controllers: [nominal, robst]\n", 5, "did you mean `robust`"},
           {"controllers: [nominal, nominal]\n", 5, "given twice"},
           {"controllers: []\n", 5, "at least one"},
           {"controllers: [nominal]\ncontroller: robust\n", 5, "keep one"},
           {"engine: clp\n", 5, "`ipopt`"},
           {"clock: {tick: 7min}\n", 5, "tick must divide"},
           {"clock:\n  tick: 5\n", 6, "such as 30min"},
           {"faults: {schema: 1, faults: [], expect: []}\n", 5, "unknown key `expect`"},
           {"faults:\n  schema: 1\n  faults:\n    - {name: a, type: demand.scale, target: {regions: [5]}, "
            "start: \"08:00\", duration: 1h, magnitude: 2}\n",
            8, "from 0 to 4"},
           {"faults:\n  schema: 1\n  faults:\n    - {name: a, type: demand.scale, target: {regions: [4]}, "
            "start: \"04:00\", duration: 1h, magnitude: 2}\n",
            8, "from 05:00"},
           {"expect: [{metric: losst, at_most: 1}]\n", 5, "did you mean `lost`"},
           {"expect: [{metric: lost}]\n", 5, "either `at_most` or `at_least`"},
           {"expect: [{metric: lost, at_most: 1, at_least: 0}]\n", 5, "either `at_most` or `at_least`"},
           {"expect: {metric: lost}\n", 5, "expected a list"},
       }) {
    const fs::path file = write(head + wrong.more);
    expect_refused([&] { read_scenario(file); }, "a.yaml:" + std::to_string(wrong.line), wrong.hint);
  }
  expect_refused([&] { read_scenario(write("city: toy-5\n")); }, "a.yaml:1", "`schema` is missing");
  expect_refused([&] { read_scenario(write("schema: 2\n")); }, "a.yaml:1", "from 1 to 1");
  expect_refused([&] { read_scenario("/no/such.yaml"); }, "/no/such.yaml", "cannot be read");
}

TEST_F(ScenarioFile, RefusesANameThatItsOwnFileDoesNotGive) {
  expect_refused([&] { read_scenario(write(head, "a\nb.yaml")); }, "b.yaml", "line break");
  expect_refused([&] { read_scenario(write(head, "a\xff.yaml")); }, "a\xff.yaml", "UTF-8");
}

TEST_F(ScenarioFile, CommandLineTakesThePlaceOfTheFile) {
  const fs::path file = write(head + "controllers: [nominal, robust]\nexpect: [{metric: served, at_least: 10}]\n");
  const fs::path faults = write(
      "schema: 1\nfaults: [{name: a, type: demand.scale, target: {regions: [4]}, start: \"06:00\", duration: 1h, "
      "magnitude: 2}]\nexpect: [{metric: lost, at_most: 900}]\n",
      "faults.yaml");
  const Scenario scenario = read_scenario(file, {.controller = "greedy",
                                                 .day = "2024-01-12",
                                                 .seed = 9,
                                                 .faults = faults,
                                                 .transport = "inproc",
                                                 .regions_per_process = 3,
                                                 .engine = "ipopt"});
  EXPECT_EQ(scenario.controllers, (std::vector<std::string>{"greedy"}));
  EXPECT_EQ(scenario.planning.controller, "greedy");
  EXPECT_EQ(scenario.world.day.date, "2024-01-12");
  EXPECT_EQ(scenario.world.seed, 9U);
  EXPECT_EQ(scenario.schedule.faults.at(0).name, "a");
  EXPECT_EQ(scenario.transport, "inproc");
  EXPECT_EQ(scenario.regions_per_process, 3);
  EXPECT_EQ(scenario.expect, (std::vector<Expect>{{"served", false, 10.0}, {"lost", true, 900.0}}));
}

TEST_F(ScenarioFile, SettingsTakeThePlaceOfAnyKey) {
  const fs::path file = write(head + "balancing: {p_shortage: 10, m1: 8}\n");
  const Scenario scenario =
      read_scenario(file, {.seed = 9,
                           .settings = {"balancing.p_shortage=15", "seed=3", "balancing.p_shortage=20",
                                        "fleet.initial_charge=[0.5, 0.6]", "controllers=[ratio, greedy]"}});
  EXPECT_EQ(scenario.planning.balancing.p_shortage, 20.0);  // the last word
  EXPECT_EQ(scenario.planning.balancing.m1, 8.0);
  EXPECT_EQ(scenario.world.seed, 9U);  // an option of its own goes before
  EXPECT_EQ(scenario.world.city.fleet.initial_charge_low, 0.5);
  EXPECT_EQ(scenario.controllers, (std::vector<std::string>{"ratio", "greedy"}));
  EXPECT_NE(resolved_yaml(scenario, "ratio").find("p_shortage: 20\n"), std::string::npos);
  const auto refused = [&](const std::string& setting, const std::string& place, const std::string& hint) {
    expect_refused([&] { read_scenario(file, {.settings = {setting}}); }, place, hint);
  };
  refused("balancing.p_shortge=20", "--set balancing.p_shortge", "did you mean `p_shortage`");
  refused("balancing.tau=many", "--set balancing.tau", "`many` is no whole number");
  refused("seed.x=1", "--set seed.x", "holds no keys");
  refused("balancing", "--set", "write KEY=VALUE");
  refused("=3", "--set", "write KEY=VALUE");
}

TEST_F(ScenarioFile, AnotherCoordinatorMayHaveOtherControllers) {
  const fs::path file = write(head + "controllers: [mine, yours]\n");
  expect_refused([&] { read_scenario(file); }, "a.yaml:5", "`mine` is not known");
  const Scenario scenario = read_scenario(file, {.coordinator = Command{"bridge"}});
  EXPECT_EQ(scenario.controllers, (std::vector<std::string>{"mine", "yours"}));
  EXPECT_EQ(scenario.planning.coordinator, Command{"bridge"});
  const Scenario one = read_scenario(file, {.controller = "third", .coordinator = Command{"bridge"}});
  EXPECT_EQ(read_scenario(write(resolved_yaml(one, "third"))).planning.coordinator, Command{"bridge"});
  EXPECT_EQ(read_scenario(file, {.coordinator = Command{"bridge"}, .transport = "inproc"}).transport, "inproc");
  const fs::path own = write(head + "controllers: [mine]\ncoordinator: [bridge]\nparameters: {reach: 3}\n");
  const Scenario without = read_scenario(own, {.controller = "greedy", .coordinator = Command{}});
  EXPECT_EQ(without.planning.controller, "greedy") << "evbal's own beside those of a scenario's coordinator";
  EXPECT_TRUE(without.planning.parameters.empty());
  expect_refused([&] { read_scenario(file, {.controller = "a b", .coordinator = Command{"bridge"}}); }, "--controller",
                 "`a b` is no name");
}

TEST_F(ScenarioFile, RefusesAWrongCommandLine) {
  const fs::path file = write(head);
  expect_refused([&] { read_scenario(file, {.controller = "robst"}); }, "--controller", "did you mean `robust`");
  expect_refused([&] { read_scenario(file, {.day = "2024-01-13"}); }, "--day", "2024-01-12");
  expect_refused([&] { read_scenario(file, {.transport = "tcp"}); }, "--transport", "`dds`, `inproc`");
  expect_refused([&] { read_scenario(file, {.regions_per_process = 0}); }, "--regions-per-process", "at least 1");
  expect_refused([&] { read_scenario(file, {.engine = "clp"}); }, "--engine", "`ipopt`");
  const fs::path faults = write("schema: 1\nfaults: []\nfautls: []\n", "faults.yaml");
  expect_refused([&] { read_scenario(file, {.faults = faults}); }, "faults.yaml:3", "unknown key `fautls`");
}

/// What resolved_yaml gives reads back as the same text.
void expect_resolved_stands(const Scenario& scenario, const fs::path& file) {
  for (const auto& controller : scenario.controllers) {
    const std::string resolved = resolved_yaml(scenario, controller);
    std::ofstream(file) << resolved;
    const Scenario again = read_scenario(file);
    EXPECT_EQ(resolved_yaml(again, controller), resolved);
    EXPECT_EQ(again.controllers, (std::vector<std::string>{controller}));
    EXPECT_EQ(again.schedule, scenario.schedule);
    EXPECT_EQ(again.expect, scenario.expect);
    EXPECT_EQ(again.name, scenario.name);
    EXPECT_EQ(again.world.day.date, scenario.world.day.date);
    EXPECT_EQ(again.transport, scenario.transport);
  }
}

TEST_F(ScenarioFile, ResolvedScenarioReadsBackUnchanged) {
  const fs::path file = write("", "scenario.resolved.yaml");
  expect_resolved_stands(
      read_scenario(write(
          head + "name: \"a \\\"quoted\\\" \\\\name: #1, {no} | - ~\"\ntransport: inproc\nregions_per_process: 2\n"
                 "expect: [{metric: unserved_ratio, at_most: 0.15}, {metric: served, at_least: 1}]\n")),
      file);
  for (const auto& entry : fs::directory_iterator(shipped)) {
    expect_resolved_stands(read_scenario(entry.path()), file);
  }
}

TEST_F(ScenarioFile, ProcessesReadTheirOwnKeysOfAResolvedScenario) {
  const Scenario scenario = read_scenario(shipped / "toy.yaml");
  YamlMap map(YamlValue::load(write(resolved_yaml(scenario, "nominal"))));
  const World world = read_world(map);
  EXPECT_EQ(world.seed, scenario.world.seed);
  EXPECT_EQ(read_planning(map).controller, "nominal");
  const Eigen::VectorXi points = world.city.points();
  EXPECT_EQ(read_resolved(map, {world.clock, {points.begin(), points.end()}}), scenario.schedule);
}

TEST(Scenario, ShippedOnesHoldASpikeInTheEveningAndAnOutageInTheMorning) {
  for (const auto& entry : fs::directory_iterator(shipped)) {
    if (entry.path().filename() == "brooklyn-evening.yaml") {  // three hours of an evening, without faults
      continue;
    }
    const Scenario scenario = read_scenario(entry.path());
    EXPECT_EQ(scenario.controllers.at(0), "nominal");
    EXPECT_EQ(scenario.controllers.at(1), "robust");
    if (entry.path().filename() == "manhattan-march-2020.yaml") {  // what goes wrong is on record
      EXPECT_TRUE(scenario.schedule.faults.empty());
      continue;
    }
    ASSERT_EQ(scenario.schedule.faults.size(), 2U);
    const Fault& outage = scenario.schedule.faults[0];
    const Fault& spike = scenario.schedule.faults[1];
    EXPECT_EQ(outage.type, EffectType::charger_outage);
    EXPECT_EQ(time_of_day(scenario.world.clock, outage.start), "07:30");
    EXPECT_EQ(outage.on_start, OnStart::evict);
    EXPECT_EQ(spike.type, EffectType::demand_scale);
    EXPECT_EQ(time_of_day(scenario.world.clock, spike.start), "17:30");
    EXPECT_GT(spike.magnitudes[0], 1.3);
    // Once drawn, faults do not follow the world's seed: every seed of a comparison meets the same.
    EXPECT_EQ(read_scenario(entry.path(), {.seed = 77}).schedule, scenario.schedule);
  }
}

TEST(Expect, NamesMetricsThatThereAre) {
  const auto measured = metric_names();
  for (const auto& metric : expectable_metrics()) {
    EXPECT_EQ(std::count(measured.begin(), measured.end(), metric), 1) << metric;
  }
}

RC_GTEST_PROP(Expect, HoldsUpToItsBound, (double bound, double beyond)) {
  RC_PRE(beyond > 0.0);
  const Expect at_most{"lost", true, bound};
  const Expect at_least{"served", false, bound};
  RC_ASSERT(at_most.holds(bound) && at_least.holds(bound));
  RC_ASSERT(at_most.holds(bound - beyond) && at_least.holds(bound + beyond));
  RC_ASSERT(bound + beyond == bound || !at_most.holds(bound + beyond));
  RC_ASSERT(bound - beyond == bound || !at_least.holds(bound - beyond));
}

}  // namespace
}  // namespace evbal

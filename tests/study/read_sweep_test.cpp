#include "experiments/study/design/sweep.hpp"
#include "experiments/study/design/tuning.hpp"
#include "tests/folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace evbal {
namespace {

const std::string sweep_head = "schema: 1\nscenario: base.yaml\ndays: [2024-01-11, 2024-01-12]\nseeds: [1, 2]\n";

/// A scenario with a fault whose time is left open, and sweeps of it.
class SweepOfToy : public ::testing::Test {
 protected:
  SweepOfToy() {
    folder_.write("base.yaml",
                  "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 1\ncontrollers: [nominal, robust]\n"
                  "faults:\n  schema: 1\n  seed: 5\n  faults:\n"
                  "    - {name: a, type: charger.outage, target: {pick: 1}, magnitude: {fraction_of_points: 1.0},\n"
                  "       start: {uniform: {min: \"06:00\", max: \"20:00\"}}, duration: 30min}\n"
                  "expect: [{metric: lost, at_most: 1}]\n");
  }

  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  Sweep read(const std::string& text) const { return read_sweep(folder_.write("sweep.yaml", text)); }

  void expect_refused(const std::string& text, int line, const std::string& word) const {
    try {
      for (const auto& day : read(text).days) {
        scenario_of(day);
      }
      FAIL() << "was accepted, expected a refusal with " << word;
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(what.find("sweep.yaml:" + std::to_string(line) + ": "), std::string::npos) << what;
      EXPECT_NE(what.find(word), std::string::npos) << what;
    }
  }

 private:
  Folder folder_;
};

TEST_F(SweepOfToy, IsEveryCombinationInOrder) {
  const Sweep sweep = read(sweep_head +
                           "faults: {calm: none, own: scenario}\n"
                           "variants:\n"
                           "  - controller: ratio\n"
                           "  - name: quick\n"
                           "    controller: turnover\n"
                           "    settings: {balancing.tau: [1, 2], clock.plan_every: 30min}\n");
  EXPECT_EQ(sweep.settings, (std::vector<std::string>{"balancing.tau", "clock.plan_every"}));
  ASSERT_EQ(sweep.days.size(), 8U + 16U);
  EXPECT_EQ(sweep.days[0].variant, "ratio");
  EXPECT_EQ(sweep.days[1].seed, 2U);
  EXPECT_EQ(sweep.days[2].day, "2024-01-12");
  EXPECT_EQ(sweep.days[4].faults, "own");
  EXPECT_EQ(sweep.days[23].settings.at("balancing.tau"), "2");
  const Scenario scenario = scenario_of(sweep.days[23]);
  EXPECT_EQ(scenario.planning.controller, "turnover");
  EXPECT_EQ(scenario.controllers, (std::vector<std::string>{"turnover"}));
  EXPECT_EQ(scenario.planning.balancing.tau, 2);
  EXPECT_EQ(scenario.world.clock.plan_every, 30);
  EXPECT_EQ(scenario.world.day.date, "2024-01-12");
  EXPECT_EQ(scenario.world.seed, 2U);
  EXPECT_EQ(scenario.transport, "inproc");
  EXPECT_TRUE(scenario.expect.empty());
}

TEST_F(SweepOfToy, HasTheSameDaysWhetherTheBusIsSecuredOrNot) {
  const std::string variants = "variants: [{controller: ratio}]\n";
  const std::string plain = resolved_yaml(scenario_of(read(sweep_head + variants).days[0]), "ratio");
  write("base.yaml", text_of(path("base.yaml")) + "security: on\n");
  EXPECT_EQ(resolved_yaml(scenario_of(read(sweep_head + variants).days[0]), "ratio"), plain);
  expect_refused(sweep_head + "variants: [{controller: ratio, settings: {security: on}}]\n", 5, "security");
}

TEST_F(SweepOfToy, DrawsFaultsAnewForEveryDayAndSeedAndForNothingElse) {
  const Sweep sweep = read(sweep_head + "variants: [{controller: ratio}, {controller: none}]\n");
  ASSERT_EQ(sweep.days.size(), 8U);
  EXPECT_EQ(sweep.days[0].faults, "");
  const auto drawn = [&](std::size_t i) { return scenario_of(sweep.days[i]).schedule; };
  EXPECT_NE(drawn(0), drawn(1));
  EXPECT_NE(drawn(0), drawn(2));
  EXPECT_EQ(drawn(1), drawn(5));
  EXPECT_EQ(drawn(1).faults.size(), 1U);
}

TEST_F(SweepOfToy, RefusesASchedulesRuns) {
  const Sweep sweep =
      read(sweep_head +
           "faults:\n  often: {schema: 1, runs: 3, faults: [{name: a, type: travel.slow, magnitude: 2,\n"
           "    target: {pick: 1}, start: \"07:00\", duration: 1h}]}\n"
           "variants: [{controller: ratio}]\n");
  try {
    scenario_of(sweep.days[0]);
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("leave its `runs` out"), std::string::npos) << error.what();
  }
}

TEST_F(SweepOfToy, TakesSchedulesFromThreePlaces) {
  const Sweep sweep = read(sweep_head +
                           "faults:\n"
                           "  calm: none\n"
                           "  own: {schema: 1, faults: [{name: b, type: demand.scale, target: {regions: [1]},\n"
                           "        start: \"08:00\", duration: 30min, magnitude: 2}]}\n"
                           "  scenario: scenario\n"
                           "variants: [{controller: ratio}]\n");
  ASSERT_EQ(sweep.days.size(), 12U);
  EXPECT_TRUE(scenario_of(sweep.days[0]).schedule.faults.empty());
  EXPECT_EQ(scenario_of(sweep.days[4]).schedule.faults.at(0).name, "b");
  EXPECT_EQ(scenario_of(sweep.days[8]).schedule.faults.at(0).name, "a");
}

TEST_F(SweepOfToy, TakesSeveralScenariosAndSeedsOfAVariantsOwn) {
  const std::string several =
      "schema: 1\nscenarios: {one: base.yaml, two: base.yaml}\ndays: [2024-01-11]\nseeds: [1]\n";
  const Sweep sweep = read(several + "variants: [{controller: none, seeds: [3, 4]}, {controller: ratio}]\n");
  ASSERT_EQ(sweep.days.size(), 4U + 2U);
  EXPECT_EQ(sweep.days[0].scenario, "one");
  EXPECT_EQ(sweep.days[1].seed, 4U);
  EXPECT_EQ(sweep.days[2].scenario, "two");
  EXPECT_EQ(sweep.days[5].seed, 1U);
  EXPECT_EQ(read(sweep_head + "variants: [{controller: none}]\n").days[0].scenario, "base");
  expect_refused(several + "variants: [{controller: none}]\nscenario: base.yaml\n", 2, "keep one");
}

TEST_F(SweepOfToy, TakesDaysAndSettingsOfAScenariosOwn) {
  const std::string head = "schema: 1\nseeds: [1]\nvariants: [{controller: none}]\n";
  const Sweep sweep = read(head +
                           "scenarios:\n"
                           "  one: {file: base.yaml, days: [2024-01-12], settings: {fleet.vehicles: 7}}\n"
                           "  two: base.yaml\ndays: [2024-01-11, 2024-01-10]\n");
  ASSERT_EQ(sweep.days.size(), 1U + 2U);
  EXPECT_EQ(sweep.days[0].day, "2024-01-12");
  EXPECT_EQ(scenario_of(sweep.days[0]).world.city.fleet.vehicles, 7);
  EXPECT_EQ(sweep.days[2].day, "2024-01-10");
  expect_refused(head + "scenarios: {one: {file: base.yaml, days: [2024-01-12]}, two: base.yaml}\n", 4, "has no days");
  expect_refused(head + "scenarios: {one: {file: base.yaml, days: [2024-01-12], settings: {day: 2024-01-11}}}\n", 4,
                 "cannot be a setting");
}

TEST_F(SweepOfToy, TakesWhatWasTunedForAnotherScenario) {
  write("frozen.yaml", "schema: 1\ntuned: {one: {r: {controller: ratio, settings: {balancing.p_ratio: 20}}}}\n");
  const std::string head = "schema: 1\nseeds: [1]\ntuned: frozen.yaml\nvariants: [{tuned: r}]\ndays: [2024-01-11]\n";
  const Sweep sweep = read(head + "scenarios: {one: base.yaml, two: {file: base.yaml, tuned_as: one}}\n");
  ASSERT_EQ(sweep.days.size(), 2U);
  EXPECT_EQ(sweep.days[1].scenario, "two");
  EXPECT_EQ(sweep.days[1].settings.at("balancing.p_ratio"), "20");
  expect_refused(head + "scenarios: {one: base.yaml, two: base.yaml}\n", 4, "nothing called `r` was tuned");
}

TEST_F(SweepOfToy, TakesWhatWasTunedForEachScenario) {
  write("frozen.yaml",
        "schema: 1\ntuned:\n"
        "  one: {r: {controller: ratio, settings: {engine: cuts, balancing.p_ratio: 20}}}\n"
        "  two: {r: {controller: ratio, settings: {engine: cuts, balancing.p_ratio: 40}}}\n");
  const std::string both =
      "schema: 1\nscenarios: {one: base.yaml, two: base.yaml}\ndays: [2024-01-11]\nseeds: [1]\ntuned: frozen.yaml\n";
  const Sweep sweep = read(both +
                           "variants: [{tuned: r}, {name: f, tuned: r, factors: {balancing.p_ratio: [0.5, 1]}},"
                           " {name: t, tuned: r, settings: {engine: ipopt, balancing.tau: 1}}]\n");
  ASSERT_EQ(sweep.days.size(), 2U + 4U + 2U);
  EXPECT_EQ(sweep.days[0].variant, "r");
  EXPECT_EQ(scenario_of(sweep.days[1]).planning.balancing.p_ratio, 40.0);
  EXPECT_EQ(sweep.days[4].settings.at("balancing.p_ratio"), "20");
  EXPECT_EQ(sweep.days[5].settings.at("balancing.p_ratio"), "40");
  EXPECT_EQ(scenario_of(sweep.days[7]).planning.engine.name, "ipopt");
  EXPECT_EQ(scenario_of(sweep.days[7]).planning.balancing.tau, 1);
  expect_refused(both + "variants: [{tuned: q}]\n", 6, "nothing called `q` was tuned");
  expect_refused(both + "variants: [{tuned: q}]\n", 6, "did you mean `r`");
  EXPECT_EQ(read(both + "variants: [{tuned: r, controller: none}]\n").days.front().controller, "none");
  expect_refused(both + "variants: [{tuned: r, factors: {balancing.eta: [2]}}]\n", 6, "has no factors");
  expect_refused(sweep_head + "variants: [{controller: none, factors: {balancing.eta: [2]}}]\n", 5, "give `tuned` too");
}

TEST_F(SweepOfToy, BoundsItsDaysWithoutFaultsOnceWhoeverControls) {
  const std::string text =
      "schema: 1\nscenarios: {one: base.yaml, two: base.yaml}\ndays: [2024-01-11, 2024-01-12]\nseeds: [1, 2]\n"
      "faults: {own: scenario, calm: none}\nvariants: [{controller: none}, {controller: ratio}]\n";
  const Sweep sweep = read(text + "bound: {prices: [5, 20], seeds: [2]}\n");
  const auto days = days_to_bound(sweep, sweep.bound);
  ASSERT_EQ(days.size(), 4U);
  EXPECT_EQ(sweep.days[days[1]].scenario, "one");
  EXPECT_EQ(sweep.days[days[1]].day, "2024-01-12");
  EXPECT_EQ(sweep.days[days[1]].seed, 2U);
  EXPECT_EQ(sweep.days[days[1]].faults, "calm");
  EXPECT_EQ(sweep.days[days[2]].scenario, "two");
  EXPECT_TRUE(read(text).bound.prices.empty());
  expect_refused(text + "bound: {prices: [20, 5], seeds: [2]}\n", 7, "prices ascend");
}

TEST_F(SweepOfToy, MayBeCutShort) {
  write("sweep.yaml",
        "schema: 1\nscenario: base.yaml\ndays: [2024-01-11, 2024-01-12, 2024-01-10]\nseeds: [1, 2]\n"
        "variants: [{controller: none}, {controller: ratio, seeds: [5, 6], settings: {balancing.p_ratio: [1, 2, 4, "
        "8]}}]\n");
  const Sweep sweep = read_sweep(path("sweep.yaml"), {.quick = true});
  ASSERT_EQ(sweep.days.size(), 6U);
  EXPECT_EQ(sweep.days[1].day, "2024-01-12");
  EXPECT_EQ(sweep.days[3].seed, 5U);
  EXPECT_EQ(sweep.days[2].settings.at("balancing.p_ratio"), "1");
  EXPECT_EQ(sweep.days[4].settings.at("balancing.p_ratio"), "8");
}

TEST_F(SweepOfToy, RefusesWhatIsWrong) {
  const auto variant = [](const std::string& settings) {
    return sweep_head + "variants:\n  - {controller: ratio, settings: {" + settings + "}}\n";
  };
  expect_refused(variant("balancing.tau: [1, 0]"), 6, "from 1");
  expect_refused(variant("balancing.tua: 1"), 6, "unknown key `tua`");
  expect_refused(variant("balancing.tau: [1, 1]"), 6, "given twice");
  expect_refused(variant("balancing.tau: []"), 6, "at least one");
  expect_refused(variant("day: 2024-01-11"), 6, "cannot be a setting");
  expect_refused(variant("demand: poisson"), 6, "cannot be a setting");
  expect_refused(variant("engine.x: cuts"), 6, "expected a word");
  expect_refused(sweep_head + "variants:\n  - {controller: ratoi}\n", 6, "did you mean `ratio`");
  expect_refused(sweep_head + "variants:\n  - {controller: ratio}\n  - {name: ratio, controller: none}\n", 7,
                 "given twice");
  expect_refused(sweep_head + "variants: [{name: \"a b\", controller: none}]\n", 5, "is no name");
  expect_refused(sweep_head + "variants: [{controller: none}]\nfaults: {}\n", 6, "no schedule");
  expect_refused(sweep_head + "variants: [{controller: none}]\njobs: 2\n", 6, "unknown key `jobs`");
  expect_refused("schema: 1\nscenario: base.yaml\nvariants: [{controller: none}]\nseeds: [1]\ndays: [2024-12-24]\n", 5,
                 "2024-12-24");
}

/// The shipped tunings and sweeps, each sweep with the first candidates of its tuning.
TEST(ShippedSweeps, CanBeRead) {
  const Folder folder;
  int sweeps = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::in_source("experiments/studies"))) {
    if (entry.path().extension() != ".yaml" || entry.path().stem().string().ends_with("-tuning")) {
      continue;
    }
    ++sweeps;
    SweepReading reading{.quick = true};
    if (const auto file = tuning_of(entry.path()); !file.empty()) {
      const Tuning tuning = read_tuning(file, true);
      reading.tuned = folder.write("tuned.yaml", tuned_yaml(winners(tuning, contests_of(tuning))));
    }
    const Sweep sweep = read_sweep(entry.path(), reading);
    EXPECT_NO_THROW(scenario_of(sweep.days.front())) << entry.path();
    EXPECT_NO_THROW(scenario_of(sweep.days.back())) << entry.path();
  }
  EXPECT_GT(sweeps, 0);
}

}  // namespace
}  // namespace evbal

#include "faults/schedule/schedule.hpp"
#include "tests/faults/schedule_fixture.hpp"

#include <gtest/gtest.h>

#include <cassert>
#include <fstream>
#include <set>

namespace evbal {
namespace {

using testing::outage;
using testing::read_runs;
using testing::read_text;
using testing::replaced;
using testing::schedule_of;
using testing::small_context;
using testing::spike;

struct Refusal {
  std::string text;
  int line;
  std::string hint;
};

void expect_refused(const Refusal& refusal) {
  try {
    read_text(refusal.text);
    FAIL() << "was accepted:\n" << refusal.text;
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_TRUE(what.starts_with("faults.yaml:" + std::to_string(refusal.line) + ": ")) << what;
    EXPECT_NE(what.find(refusal.hint), std::string::npos) << what;
  }
}

Refusal spike_with(const std::string& from, const std::string& to, const std::string& hint) {
  return {schedule_of({replaced(spike, from, to)}), 2, hint};
}

Refusal outage_with(const std::string& from, const std::string& to, const std::string& hint) {
  return {schedule_of({replaced(outage, from, to)}), 2, hint};
}

TEST(Schedule, RefusesAFaultThatIsWrong) {
  for (const auto& refusal : std::vector<Refusal>{
           spike_with("demand.scale", "sensor.broken", "choose one of `demand.scale`, `charger.outage`"),
           spike_with("demand.scale", "demand.scal", "did you mean `demand.scale`"),
           spike_with("name: spike, ", "", "`name` is missing"),
           spike_with("name: spike", "name: \"a b\"", "is no name"),
           spike_with("magnitude", "magnitud", "`magnitude` is missing"),
           spike_with("magnitude: 1.8", "magnitude: 1.8, mood: bad", "unknown key `mood`"),
           spike_with("magnitude: 1.8", "magnitude: 1.8, on_start: evict", "unknown key `on_start`"),
           spike_with("magnitude: 1.8", "magnitude: -1", "from 0 to 100"),
           spike_with("magnitude: 1.8", "magnitude: {fraction_of_points: 1}", "one distribution"),
           spike_with("magnitude: 1.8", "magnitude: {norml: {mean: 1, sd: 1}}", "did you mean `normal`"),
           spike_with("magnitude: 1.8", "magnitude: {normal: {mean: 1}}", "`sd` is missing"),
           spike_with("magnitude: 1.8", "magnitude: {normal: {mean: 1, sd: 0}}", "greater than 0"),
           spike_with("magnitude: 1.8", "magnitude: {normal: {mean: 1, sd: 1, mni: 0}}", "unknown key `mni`"),
           spike_with("magnitude: 1.8", "magnitude: {uniform: {min: 2, max: 1}}", "min is greater than max"),
           spike_with("magnitude: 1.8", "magnitude: 1.8, visible: maybe", "neither `true` nor `false`"),
           spike_with("magnitude: 1.8", "magnitude: 1.8, ramp: 50min", "at most half of the duration"),
           spike_with("90min", "90", "such as 30min"),
           spike_with("90min", "90s", "whole minutes"),
           spike_with("90min", "25h", "from 1min to 1440min"),
           spike_with("90min", "{lognormal: {median: 40, sigma: 0.6}}", "such as 30min"),
           spike_with("[2, 0]", "[2, 5]", "from 0 to 4"),
           spike_with("[2, 0]", "[2, 2]", "given twice"),
           spike_with("[2, 0]", "[]", "names no region"),
           spike_with("{regions: [2, 0]}", "{region: 2}", "did you mean `regions`"),
           spike_with("{regions: [2, 0]}", "{regions: [2], pick: 1}",
                      "either `regions: [..]`, or `pick: n` or `fraction: f`"),
           spike_with("{regions: [2, 0]}", "{pick: 6}", "from 1 to 5"),
           spike_with("{regions: [2, 0]}", "{pick: 1, fraction: 0.5}", "either `regions: [..]`"),
           spike_with("{regions: [2, 0]}", "{fraction: 1.5}", "from 0 to 1"),
           spike_with("{regions: [2, 0]}", "{fraction: 1, of: {min_points: 21}}", "no region fits"),
           spike_with("{regions: [2, 0]}", "{pick: 1, of: {min_points: 21}}", "no region fits"),
           spike_with("\"17:30\"", "\"04:59\"", "from 05:00 to 23:59"),
           spike_with("\"17:30\"", "5.30pm", "is no time of day"),
           spike_with("\"17:30\"", "{exponential: {mean: 5min}}", "`uniform`, `normal`"),
           spike_with("start: \"17:30\", ", "", "either `start` or `arrivals`"),
           spike_with("start: \"17:30\"", "arrivals: {poisson: {per_hour: 0}}", "from 0.001 to 60"),
           spike_with("start: \"17:30\"", "arrivals: {poisson: {per_hour: 1, from: \"04:00\"}}", "within the day"),
           outage_with("[1]", "[2]", "those with points are 1, 3, 4"),
           outage_with("duration: 2h", "duration: 2h, ramp: 5min", "unknown key `ramp`"),
           outage_with("duration: 2h", "duration: 2h, on_start: explode", "choose one of `drain`, `evict`"),
           outage_with("{fraction_of_points: 0.5}", "0.5", "expected a map"),
           outage_with("{fraction_of_points: 0.5}", "{fraction_of_points: 1.5}", "from 0.01 to 1"),
           outage_with("{fraction_of_points: 0.5}", "{points: 5}", "at most 4"),
           outage_with("{fraction_of_points: 0.5}", "{points: 1, fraction_of_points: 1}", "either"),
       }) {
    expect_refused(refusal);
  }
}

/// A schedule of one fault of a type, with its own fields.
std::string fault_of(const std::string& type, const std::string& fields) {
  return schedule_of({"{name: a, type: " + type + ", start: \"07:00\", " + fields});
}

TEST(Schedule, ReadsEveryTypeWithItsFields) {
  const auto only = [](const std::string& type, const std::string& fields) {
    return read_text(fault_of(type, fields)).faults.at(0);
  };
  const auto shift = only("demand.shift", "target: {regions: [1]}, to: 4, magnitude: 0.5, duration: 1h, ramp: 10min");
  EXPECT_EQ(shift.to, 4);
  EXPECT_EQ(shift.ramp, 10);
  const auto broken = only("fleet.breakdown", "target: {pick: 1}, magnitude: {vehicles: 3}, duration: 1h");
  EXPECT_EQ(broken.magnitudes, std::vector<double>{3.0});
  const auto lie = only("sensor.biased", "target: {regions: [2], field: points}, magnitude: -4, duration: 1h");
  EXPECT_EQ(lie.field, ReportField::points);
  EXPECT_EQ(lie.magnitudes, std::vector<double>{-4.0});
  const auto late = only("sensor.delayed", "target: {regions: [2], field: vacant}, magnitude: 20min, duration: 1h");
  EXPECT_EQ(late.magnitudes, std::vector<double>{20.0});
  const auto crash = only("process.kill", "target: {agent: 3}, restart_after: 10min");
  EXPECT_EQ(crash.regions, std::vector<int>{3});
  EXPECT_EQ(crash.duration, 10);
  const auto leaderless = only("process.pause", "target: {coordinator: true}, duration: 10min");
  EXPECT_EQ(leaderless.process, ProcessRole::coordinator);
  EXPECT_EQ(leaderless.regions, std::vector<int>{no_region});
  const auto lossy = only("network.drop", "target: {topic: report, fraction: 0.4}, probability: 0.3, duration: 1h");
  EXPECT_EQ(lossy.topic, NetworkTopic::report);
  EXPECT_EQ(lossy.magnitudes, (std::vector<double>{0.3, 0.3}));
  EXPECT_EQ(only("network.delay", "target: {topic: plan}, magnitude: 2min, duration: 1h").regions.size(), 5U);
  const auto starved = only("solver.starve", "magnitude: {iterations: 3}, duration: 1h");
  EXPECT_EQ(starved.magnitudes, std::vector<double>{3.0});
  EXPECT_EQ(starved.regions, std::vector<int>{no_region});
}

TEST(Schedule, RefusesFieldsThatAreNotOfTheType) {
  const auto refused = [](const std::string& type, const std::string& fields, const std::string& hint) {
    expect_refused({fault_of(type, fields), 2, hint});
  };
  refused("demand.shift", "target: {regions: [1]}, magnitude: 0.5, duration: 1h", "`to` is missing");
  refused("demand.shift", "target: {regions: [1]}, to: 5, magnitude: 0.5, duration: 1h", "from 0 to 4");
  refused("demand.add", "target: {regions: [1]}, to: 2, magnitude: 5, duration: 1h", "unknown key `to`");
  refused("charger.derate", "target: {regions: [0]}, magnitude: 0.5, duration: 1h", "has no charging points");
  refused("charger.derate", "target: {regions: [1]}, magnitude: 2, duration: 1h", "from 0 to 1");
  refused("charger.block", "target: {regions: [1]}, magnitude: {points: 1}, duration: 1h, on_start: evict", "on_start");
  refused("charger.no_start", "target: {regions: [0]}, probability: 0.5, duration: 1h", "has no charging points");
  refused("charger.no_start", "target: {regions: [1]}, probability: 1.5, duration: 1h", "from 0 to 1");
  refused("fleet.breakdown", "target: {regions: [1]}, magnitude: {cars: 2}, duration: 1h", "unknown key `cars`");
  refused("fleet.breakdown", "target: {regions: [1]}, magnitude: {vehicles: 1.5}, duration: 1h", "whole number");
  refused("travel.slow", "target: {regions: [1]}, magnitude: 0.5, duration: 1h", "from 1 to 10");
  refused("sensor.stuck", "target: {regions: [1]}, duration: 1h", "`field` is missing");
  refused("sensor.stuck", "target: {regions: [1], field: vacnt}, duration: 1h", "did you mean `vacant`");
  refused("sensor.off", "target: {regions: [1], field: vacant}, magnitude: 1, duration: 1h", "unknown key `magnitude`");
  refused("sensor.off", "target: {regions: [1], field: vacant}, duration: 1h, visible: true", "unknown key `visible`");
  refused("host.down", "target: {host: 2}, restart_after: 5min", "from 0 to 1");
  refused("host.down", "target: {agent: 1}, restart_after: 5min", "unknown key `agent`");
  refused("host.down", "target: {}, restart_after: 5min", "expected `host: k`");
  refused("process.kill", "target: {agent: 5}, restart_after: 5min", "from 0 to 4");
  refused("process.kill", "target: {regions: [1]}, restart_after: 5min", "unknown key `regions`");
  refused("process.kill", "target: {agent: 1}, duration: 5min", "`restart_after` is missing");
  refused("process.kill", "target: {coordinator: false}, restart_after: 5min", "expected `coordinator: true`");
  refused("process.kill", "target: {coordinator: true, agent: 1}, restart_after: 5min", "unknown key `agent`");
  refused("process.slow", "target: {injector: true}, duration: 5min, magnitude: 30s", "from 1min");
  refused("network.drop", "target: {topic: tick}, duration: 1h, probability: 1",
          "choose one of `all`, `report`, `plan`");
  refused("network.drop", "target: {topic: report}, duration: 1h, magnitude: 1", "`probability` is missing");
  refused("network.partition", "target: {}, duration: 1h", "either `regions: [..]`");
  refused("network.partition", "target: {topic: plan, regions: [1]}, duration: 1h", "unknown key `topic`");
  refused("solver.fail", "target: {coordinator: true}, duration: 1h", "unknown key `target`");
  refused("solver.starve", "magnitude: {iterations: 0}, duration: 1h", "from 1 to");
}

TEST(Schedule, RefusesFaultsThatExcludeEachOther) {
  const auto both = [](const std::string& first, const std::string& second) {
    return schedule_of({"{name: a, start: \"07:00\", type: " + first, "{name: b, start: \"07:30\", type: " + second});
  };
  const std::string stuck = "sensor.stuck, duration: 1h, target: {regions: [1], field: ";
  expect_refused({both(stuck + "vacant}", stuck + "vacant}"), 3, "both are sensor.stuck in region 1 from 07:30"});
  EXPECT_NO_THROW(read_text(both(stuck + "vacant}", stuck + "points}")));
  expect_refused(
      {both("process.kill, target: {agent: 2}, restart_after: 1h", "process.pause, target: {pick: 5}, duration: 1h"), 3,
       "both act on agent 2"});
  EXPECT_NO_THROW(read_text(both("process.kill, target: {coordinator: true}, restart_after: 1h",
                                 "process.kill, target: {injector: true}, restart_after: 1h")));
  const std::string drop = "network.drop, duration: 1h, probability: 1, target: {regions: [1], topic: ";
  expect_refused({both(drop + "plan}", drop + "all}"), 3, "both are network.drop in region 1"});
  EXPECT_NO_THROW(read_text(both(drop + "plan}", drop + "report}")));
  expect_refused({both("solver.fail, duration: 1h", "solver.fail, duration: 1h"), 3, "in the coordinator"});
}

TEST(Schedule, RefusesRunsThatMakeNoSense) {
  expect_refused({schedule_of({spike}, "runs: 3, "), 1, "all runs would be the same"});
  expect_refused({schedule_of({spike}, "runs: 0, "), 1, "from 1 to"});
  expect_refused({"schema: 1\nresolved: true\nruns: 1\nfaults: []\n", 3, "nothing is left to draw"});
  const std::string here = "{name: a, type: solver.fail, duration: 1h, start: \"07:00\"";
  const std::string there =
      "{name: b, type: solver.fail, duration: 1h, start: {uniform: {min: \"08:00\", max: \"20:00\"}}";
  EXPECT_NO_THROW(read_runs(schedule_of({here, there}, "runs: 50, ")));
  expect_refused({schedule_of({here, replaced(there, "08:00", "07:50")}, "runs: 500, "), 3, "of 500)"});
}

TEST(Schedule, RefusesAHeadThatIsWrong) {
  for (const auto& refusal : std::vector<Refusal>{
           {"seed: 1\nfaults: []\n", 1, "`schema` is missing"},
           {"schema: 2\nfaults: []\n", 1, "from 1 to 1"},
           {"schema: 1\n", 1, "`faults` is missing"},
           {"schema: 1\nfaults: {}\n", 2, "expected a list"},
           {"schema: 1\nseed: -1\nfaults: []\n", 2, "is no seed"},
           {"schema: 1\nfaults: []\nguards: {}\n", 3, "did you mean `guard`"},
           {"schema: 1\nguard: {overlap: add}\nfaults: []\n", 2, "choose one of `reject`"},
           {"schema: 1\nguard:\n  max_active: 0\nfaults: []\n", 3, "from 1 to 1000"},
       }) {
    expect_refused(refusal);
  }
}

TEST(Schedule, RefusesWhatTheGuardForbids) {
  const auto other = [](std::string fault) { return replaced(std::move(fault), "name: ", "name: other-"); };
  for (const auto& refusal : std::vector<Refusal>{
           {schedule_of({spike, spike}), 3, "has the name of `spike` (line 2)"},
           {schedule_of({spike, replaced(other(spike), "17:30", "18:55")}), 3,
            "`other-spike` (line 3) overlaps `spike` (line 2): both are demand.scale in region 0 from 18:55 to 19:00"},
           {schedule_of({outage, spike, replaced(other(spike), "[2, 0]", "[1]")}, "guard: {max_active: 1}, "), 4,
            "2 faults are active at 17:30"},
           {schedule_of({outage}, "guard: {min_working_points: 35}, "), 2,
            "leaves 34 charging points working at 07:30"},
       }) {
    expect_refused(refusal);
  }
}

TEST(Schedule, AcceptsWhatTheGuardAllows) {
  const auto other = [](std::string fault) { return replaced(std::move(fault), "name: ", "name: other-"); };
  EXPECT_NO_THROW(read_text(schedule_of({spike, replaced(other(spike), "17:30", "19:00")})));
  EXPECT_NO_THROW(read_text(schedule_of({spike, replaced(other(spike), "[2, 0]", "[1, 3]")})));
  EXPECT_NO_THROW(read_text(schedule_of({outage}, "guard: {min_working_points: 34, max_active: 1}, ")));
}

TEST(Schedule, RefusesAResolvedListThatWasAltered) {
  const std::string good =
      "schema: 1\nresolved: true\nfaults:\n  - {name: a, type: charger.outage, target: {regions: [1, 3]}, "
      "magnitude: [4, 1], start: \"07:00\", duration: 5min, on_start: drain, visible: true}\n";
  ASSERT_NO_THROW(read_text(good));
  for (const auto& refusal : std::vector<Refusal>{
           {replaced(good, "[4, 1]", "[4]"), 4, "one magnitude for each"},
           {replaced(good, "{regions: [1, 3]}", "{pick: 2}"), 4, "still to be drawn"},
           {replaced(good, "[4, 1]", "[5, 1]"), 4, "from 1 to 4"},
           {replaced(good, "[4, 1]", "[4, 0.5]"), 4, "whole number"},
           {replaced(good, "07:00", "24:00"), 4, "outside of the day"},
           {replaced(good, "5min", "{uniform: {min: 1min, max: 2min}}"), 4, "expected a duration"},
           {replaced(good, "on_start: drain, ", ""), 4, "`on_start` is missing"},
       }) {
    expect_refused(refusal);
  }
}

TEST(Schedule, InjectorTakesAResolvedListOnly) {
  const auto read = [](const std::string& text) {
    YamlMap scenario(YamlValue::parse(text, "scenario.resolved.yaml"));
    return read_resolved(scenario, small_context());
  };
  EXPECT_EQ(read("faults: {schema: 1, resolved: true, seed: 3, faults: []}\n").seed, 3U);
  EXPECT_THROW(read("faults: {schema: 1, faults: []}\n"), Error);
  EXPECT_THROW(read("faults: {schema: 1, resolved: false, faults: []}\n"), Error);
  EXPECT_THROW(read("city: toy-5\n"), Error);
}

}  // namespace
}  // namespace evbal

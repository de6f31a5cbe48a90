#include "agents/world/world.hpp"

#include "agents/world/draws.hpp"
#include "agents/world/synthetic.hpp"
#include "tests/folder.hpp"
#include "tests/support/yaml_of.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace evbal {
namespace {

const std::string smallest = "city: toy-5\nday: \"2024-01-08\"\nseed: 7\n";

World read(const std::string& text) {
  YamlMap map(YamlValue::parse(text, "a.yaml"));
  World world = read_world(map);
  map.finish();
  return world;
}

void expect_refused(const std::string& extra, const std::string& place, const std::string& word) {
  try {
    read(smallest + extra);
    FAIL() << "was accepted: " << extra;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_TRUE(std::string(error.what()).starts_with(place + ": ")) << error.what();
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

std::string world_yaml(const World& world) {
  return yaml_of([&](YamlWriter& yaml) { write_world(yaml, world); });
}

TEST(World, TakesThePackAsItIs) {
  const World world = read(smallest);
  EXPECT_EQ(world.city.size(), 5);
  EXPECT_EQ(world.day.date, "2024-01-08");
  EXPECT_EQ(world.seed, 7U);
  EXPECT_EQ(world.demand, DemandModel::recorded);
  EXPECT_EQ(world.clock.start, world.city.day_start);
  EXPECT_GT(world.city.fleet.vehicles, 0);
  EXPECT_FALSE(world.city.charging.top_up);
}

TEST(World, EveryAssumptionCanBeOverridden) {
  const World world = read(smallest + R"(
demand: poisson
clock: {start: "06:00", end: "09:00", tick: 2min, step: 30min, plan_every: 10min}
fleet: {vehicles: 12, battery_kwh: 33.3, km_per_kwh: 6.1, initial_charge: [0.25, 0.5]}
charging: {power_kw: 22, session_quantiles: [5min, 0.5h, 1h], top_up: true}
passengers: {patience: [3min, 4.5min]}
stations:
  - {name: "the \"hub\"", region: 4, points: 9}
  - {name: corner, region: r1, points: 0}
)");
  EXPECT_EQ(world.demand, DemandModel::poisson);
  EXPECT_EQ(world.clock.minutes(), 180);
  EXPECT_EQ(world.clock.tick, 2);
  EXPECT_EQ(world.city.fleet.vehicles, 12);
  EXPECT_EQ(world.city.fleet.initial_charge_high, 0.5);
  EXPECT_EQ(world.city.charging.session_quantiles, (std::vector<double>{5.0, 30.0, 60.0}));
  EXPECT_TRUE(world.city.charging.top_up);
  EXPECT_TRUE(read(world_yaml(world)).city.charging.top_up);
  EXPECT_EQ(world.city.passengers.patience_high, 4.5);
  ASSERT_EQ(world.city.stations.size(), 2U);
  EXPECT_EQ(world.city.points()[4], 9);
  EXPECT_EQ(world.city.stations[1].region, 0);
}

TEST(World, PlacesAFleetEvenlyIfTold) {
  const World world = read(smallest + "fleet: {vehicles: 17, placement: even}\n");
  std::vector<std::size_t> cars;
  for (const auto& region : draw_fleet(world)) {
    cars.push_back(region.size());
  }
  EXPECT_EQ(cars, (std::vector<std::size_t>{4, 4, 3, 3, 3}));
  EXPECT_EQ(read(world_yaml(world)).city.fleet.placement, FleetPlacement::even);
  EXPECT_EQ(world_yaml(read(smallest)).find("placement"), std::string::npos);
  expect_refused("fleet: {placement: evn}\n", "a.yaml:4", "even");
}

TEST(World, ComesBackFromItsText) {
  const std::string text = world_yaml(read(smallest + "fleet: {km_per_kwh: 5.4321}\nclock: {end: \"11:00\"}\n"));
  EXPECT_NE(text.find("city: \"toy-5\""), std::string::npos) << text;
  const World again = read(text);
  EXPECT_EQ(world_yaml(again), text);
  EXPECT_EQ(again.city.fleet.km_per_kwh, 5.4321);
  EXPECT_EQ(again.clock.end, 11 * 60);
  ASSERT_FALSE(again.city.stations.empty());
  const World pack = read(smallest);
  EXPECT_EQ(again.city.stations[0].place.lat, pack.city.stations[0].place.lat);
}

TEST(World, RefusesWhatDoesNotFit) {
  expect_refused("fleet: {vehicels: 3}\n", "a.yaml:4", "did you mean `vehicles`");
  expect_refused("fleet: {vehicles: -3}\n", "a.yaml:4", "from 0");
  expect_refused("fleet: {initial_charge: [0.9, 0.3]}\n", "a.yaml:4", "low not above high");
  expect_refused("charging: {session_quantiles: [20min, 10min]}\n", "a.yaml:4", "ascending");
  expect_refused("charging: {session_quantiles: [20min, 99999999999h]}\n", "a.yaml:4", "24h");
  expect_refused("charging: {session_quantiles: [0min, 10min]}\n", "a.yaml:4", "1min");
  expect_refused("passengers: {patience: [1min, 99999999999h]}\n", "a.yaml:4", "24h");
  expect_refused("passengers: {patience: [8, 20]}\n", "a.yaml:4", "duration");
  expect_refused("clock: {tick: 7min}\n", "a.yaml:4", "tick must divide");
  expect_refused("clock: {start: \"04:00\"}\n", "a.yaml:4", "records");
  expect_refused("demand: guessed\n", "a.yaml:4", "recorded");
  expect_refused("stations:\n  - {name: a, region: 5, points: 2}\n", "a.yaml:5", "from 0 to 4");
  expect_refused("stations:\n  - {name: a, region: nowhere, points: 2}\n", "a.yaml:5", "not known");
  expect_refused("stations:\n  - {name: a, region: 1, points: 2}\n  - {name: a, region: 2, points: 2}\n", "a.yaml:6",
                 "twice");
}

// The clock that a scenario does not give must fit the city as one that it gives.
TEST(World, RefusesACityWhoseDayHasNoWholeSteps) {
  const Folder folder;
  SyntheticCity made = synthetic_city({.regions = 2, .train_days = 0, .test_days = 1});
  made.city.day_start += 10;
  made.city.step_minutes = 10;
  made.days.front().steps.resize(static_cast<std::size_t>((24 * 60 - made.city.day_start) / 10));
  write_city(made.city, made.days, folder.path() / "pack");
  const std::string scenario =
      "city: " + (folder.path() / "pack").string() + "\nday: \"" + made.days.front().date + "\"\nseed: 7\n";
  try {
    read(scenario);
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("a.yaml:1: ")) << error.what();
    EXPECT_NE(std::string(error.what()).find("step must divide"), std::string::npos) << error.what();
  }
  EXPECT_EQ(read(scenario + "clock: {start: \"05:30\"}\n").clock.minutes(), 1110);
}

TEST(World, RefusesUnknownCitiesAndDays) {
  const auto refused = [](const std::string& text, const std::string& place) {
    try {
      read(text);
      FAIL() << "was accepted: " << text;
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(place)) << error.what();
    }
  };
  refused("city: atlantis\nday: \"2024-01-08\"\nseed: 7\n", "a.yaml:1: ");
  refused("city: toy-5\nday: \"2031-01-08\"\nseed: 7\n", "a.yaml:2: ");
  refused("city: toy-5\nday: \"2024-01-08\"\n", "a.yaml:1: ");
}

}  // namespace
}  // namespace evbal

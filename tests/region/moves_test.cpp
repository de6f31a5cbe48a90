// What a region does with a plan's moves, and tells of the cars that they may be of.

#include "agents/region/region_plant.hpp"
#include "tests/region/plant_fixture.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

using test::car;
using test::Life;
using test::plant_of;
using test::two_regions;

// A far move that came last would find only the car that does not get there.
TEST(RegionMoves, SendsTheFarthestFirst) {
  World world = test::world_of({.regions = 3, .trips_per_day = 0.0, .vehicles = 0, .stations = 1, .points = 1});
  world.city.stations.front().region = 1;
  world.city.km.setConstant(2.0);
  world.city.km(0, 2) = 10.0;  // 2 kWh, and 0.4 on to the station
  world.city.fleet.battery_kwh = 20.0;
  world.city.fleet.km_per_kwh = 5.0;
  const auto refused = [&](Errand errand, const std::vector<Passenger>& passengers, const std::vector<Vehicle>& cars) {
    Plan plan = test::hold(0);
    plan.moves = {{.from = 0, .to = 1, .count = 1, .errand = errand},
                  {.from = 0, .to = 2, .count = 1, .errand = errand}};
    return Life{plant_of(world, 0, passengers, cars)}.next({}, {}, &plan).refused;
  };
  EXPECT_EQ(refused(Errand::rebalance, {}, {car(0, 1.0), car(1, 5.0)}), 0);
  EXPECT_EQ(refused(Errand::charge, {{.appears = 600, .destination = 2}}, {car(0, 0.5), car(1, 2.2)}), 0);
  EXPECT_EQ(refused(Errand::charge, {{.appears = 600, .destination = 2}}, {car(0, 0.5), car(1, 1.9)}), 1);
}

TEST(RegionMoves, TopsUpTheLowestChargesWhereTheWorldKnowsThat) {
  World world = two_regions(2);
  Plan plan = test::hold(0);
  plan.moves = {{.from = 0, .to = 0, .count = 3, .errand = Errand::charge},
                {.from = 0, .to = 0, .count = 1, .errand = Errand::rebalance}};
  const std::vector<Vehicle> cars = {car(0, 18.0), car(1, 16.9), car(2, 9.0)};  // 17 kWh are 85 %
  Life without{plant_of(world, 0, {}, cars)};
  EXPECT_EQ(without.next({}, {}, &plan).refused, 4);
  world.city.charging.top_up = true;
  Life life{plant_of(world, 0, {}, cars)};
  life.begin();
  const Report report = life.plant.report();
  EXPECT_EQ(report.vacant, 3);
  EXPECT_EQ(report.chargeable, 2);
  const Departures said = life.plant.live(&plan);
  EXPECT_EQ(said.refused, 2) << "one is full enough, and nobody is sent to where he is";
  EXPECT_EQ(said.topped_up, 2);
  EXPECT_TRUE(said.departures.empty());
  EXPECT_EQ(said.vacant, 1);
  EXPECT_EQ(said.plugged, 2);
  EXPECT_NEAR(life.plant.state().sessions.at(0).vehicle.battery_kwh, 9.0 + 5.0, 1e-9) << "the lowest charge first";
  EXPECT_EQ(life.next().topped_up, 0);
  EXPECT_EQ(life.next().completions, 2);
  EXPECT_EQ(life.plant.state().vacant.size(), 3U);
  plan.moves = {{.from = 1, .to = 1, .count = 1, .errand = Errand::charge}};
  Life nowhere{plant_of(world, 1, {}, {car(0, 9.0)})};
  EXPECT_EQ(nowhere.next({}, {}, &plan).refused, 1) << "no points there";
}

TEST(RegionMoves, ReportsWhichLowBatteryCarsDoNotGetEverywhere) {
  const World world = two_regions(1);
  const std::vector<Passenger> passengers = {{.appears = 600, .patience = 5, .destination = 1}};
  Life life{plant_of(world, 1, passengers, {car(0, 2.2), car(1, 1.0), car(2, 0.25), car(3, 9.0)})};
  life.begin();
  EXPECT_EQ(life.plant.report().reach_m, (std::vector<std::int32_t>{1250, 5000}));
  life.plant.live(nullptr);
  life.begin({{.type = EffectType::fleet_drain, .region = 1, .magnitude = 2.0}});
  EXPECT_EQ(life.plant.report().reach_m, (std::vector<std::int32_t>{625, 2500, 5500})) << "all three are low";
}

}  // namespace
}  // namespace evbal

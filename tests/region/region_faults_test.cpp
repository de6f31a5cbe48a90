#include "tests/region/plant_fixture.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace evbal {
namespace {

using test::car;
using test::Life;
using test::plant_of;
using test::two_regions;

Effect effect(EffectType type, double magnitude, bool visible = true) {
  return {.type = type, .region = 0, .magnitude = magnitude, .visible = visible};
}

/// All want to cross: below 4 kWh a car is low.
const std::vector<Passenger> late_crossing = {{.appears = 600, .patience = 5, .destination = 1}};

TEST(RegionFaults, AddedPassengersComeByTheHour) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, late_crossing, {})};
  int demand = 0;
  double observed = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    const Departures said = life.next({effect(EffectType::demand_add, 60.0)});
    demand += said.demand;
    observed += said.observed.at(0).amount;
    for (const auto& fate : said.fates) {
      EXPECT_EQ(fate.destination, 1) << "where this region's passengers go";
    }
  }
  EXPECT_NEAR(demand, 500, 70);
  EXPECT_EQ(observed, demand);
}

TEST(RegionFaults, ShiftedPassengersGoElsewhere) {
  const World world = two_regions(1);
  const std::vector<Passenger> passengers(400, {.appears = 0, .patience = 0, .destination = 1});
  std::vector<Passenger> numbered = passengers;
  for (int i = 0; i < 400; ++i) {
    numbered[static_cast<std::size_t>(i)].index = i;
  }
  Effect shift = effect(EffectType::demand_shift, 0.25);
  shift.to = 0;
  Life life{plant_of(world, 0, numbered, {})};
  const Departures said = life.next({shift});
  const auto redirected = std::ranges::count_if(said.fates, [](const Fate& fate) { return fate.destination == 0; });
  EXPECT_NEAR(static_cast<double>(redirected), 100.0, 35.0);
  EXPECT_EQ(said.observed.at(0).amount, static_cast<double>(redirected));
  EXPECT_EQ(said.demand, 400) << "nobody more, nobody less";
}

TEST(RegionFaults, ADeratedChargerChargesSlower) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, late_crossing, {car(0, 1.0)})};
  const Departures said = life.next({effect(EffectType::charger_derate, 0.25)});
  EXPECT_NEAR(said.charged_kwh, 1.25, 1e-9);
  EXPECT_NEAR(said.observed.at(0).amount, 3.75, 1e-9);
  EXPECT_NEAR(life.next().charged_kwh, 5.0, 1e-9);
}

TEST(RegionFaults, NobodyPlugsInAtABlockedPoint) {
  const World world = two_regions(2);
  Life life{plant_of(world, 0, late_crossing, {car(0, 1.0)})};
  life.next();
  const Departures said =
      life.next({effect(EffectType::charger_block, 2.0)}, {{.region = 0, .minute = 6, .vehicle = car(1, 1.0)}});
  EXPECT_EQ(said.plugged, 1) << "who was plugged in stays";
  EXPECT_EQ(said.low_battery, 1);
  EXPECT_EQ(said.points, 2) << "the points work";
  EXPECT_EQ(said.observed.at(0).amount, 1.0) << "one was free to be blocked";
  life.begin({effect(EffectType::charger_block, 2.0)});
  EXPECT_EQ(life.plant.report().points, 1);
  life.plant.live(nullptr);
  life.begin({effect(EffectType::charger_block, 2.0, false)});
  EXPECT_EQ(life.plant.report().points, 2);
  EXPECT_EQ(life.plant.live(nullptr).plugged, 0);
  EXPECT_EQ(life.next().plugged, 1);
}

TEST(RegionFaults, ASessionThatDoesNotStartIsTriedAgain) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, late_crossing, {car(0, 1.0), car(1, 1.0)})};
  const Effect certain = effect(EffectType::charger_no_start, 1.0);
  for (int tick = 0; tick < 3; ++tick) {
    const Departures said = life.next({certain});
    EXPECT_EQ(said.plugged, 1) << "it keeps its point";
    EXPECT_EQ(said.low_battery, 1);
    EXPECT_EQ(said.charged_kwh, 0.0);
    EXPECT_EQ(said.completions, 0);
    EXPECT_EQ(said.queue_minutes, 5) << "of the other car";
    EXPECT_EQ(said.observed.at(0).amount, 1.0) << "a try takes five minutes";
    EXPECT_EQ(life.plant.state().sessions.at(0).vehicle.id, 0) << "the same car again";
    EXPECT_EQ(life.plant.state().sessions.at(0).vehicle.sessions, 0);
  }
  EXPECT_NEAR(life.next().charged_kwh, 5.0, 1e-9);
  const Departures after = life.next();
  EXPECT_NEAR(after.charged_kwh, 5.0, 1e-9);
  EXPECT_EQ(life.next().completions, 1);
}

TEST(RegionFaults, AsManySessionsDoNotStartAsAreSaid) {
  const World world = two_regions(500);
  std::vector<Vehicle> low;
  for (int id = 0; id < 500; ++id) {
    low.push_back(car(id, 1.0));
  }
  const auto failed = [&](int seed) {
    World other = world;
    other.seed = static_cast<std::uint64_t>(seed);
    Life life{plant_of(other, 0, late_crossing, low)};
    const Departures said = life.next({effect(EffectType::charger_no_start, 0.3)});
    EXPECT_EQ(said.plugged, 500);
    EXPECT_NEAR(said.charged_kwh, 5.0 * (500.0 - said.observed.at(0).amount), 1e-6);
    return said.observed.at(0).amount;
  };
  EXPECT_NEAR(failed(1), 150.0, 40.0);
  EXPECT_EQ(failed(1), failed(1));
  EXPECT_NE(failed(1), failed(2));
}

TEST(RegionFaults, APointThatFailsDuringATryLeavesItsCarAtTheHead) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, late_crossing, {car(0, 1.0), car(1, 1.0)})};
  life.next({effect(EffectType::charger_no_start, 1.0)});
  Effect outage = effect(EffectType::charger_outage, 1.0);
  outage.on_start = OnStart::evict;
  const Departures said = life.next({outage});
  EXPECT_EQ(said.observed.at(0).evicted, 1);
  EXPECT_EQ(said.low_battery, 2);
  EXPECT_EQ(life.plant.state().queue.front().id, 0);
}

TEST(RegionFaults, BrokenVehiclesComeBackAsTheyWere) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, {}, {car(0, 9.0), car(1, 8.0), car(2, 7.0)})};
  const Departures during = life.next({effect(EffectType::fleet_breakdown, 2.0)});
  EXPECT_EQ(during.broken, 2);
  EXPECT_EQ(during.vacant, 1);
  EXPECT_EQ(during.observed.at(0).amount, 2.0);
  EXPECT_EQ(life.plant.census().size(), 3U);
  const Departures after = life.next();
  EXPECT_EQ(after.broken, 0);
  EXPECT_EQ(after.vacant, 3);
  EXPECT_EQ(life.plant.state().vacant.at(2).battery_kwh, 9.0);
}

TEST(RegionFaults, BreakdownsWaitForVehicles) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, {}, {})};
  const Effect breakdown = effect(EffectType::fleet_breakdown, 2.0);
  EXPECT_EQ(life.next({breakdown}, {{.region = 0, .minute = 2, .vehicle = car(1, 9.0)}}).broken, 0);
  EXPECT_EQ(life.next({breakdown}).broken, 1);
}

TEST(RegionFaults, ABreakdownThatNobodyIsToldIsReportedVacant) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, {}, {car(0, 9.0), car(1, 8.0)})};
  life.begin({effect(EffectType::fleet_breakdown, 1.0, true)});
  EXPECT_EQ(life.plant.report().vacant, 1);
  life.plant.live(nullptr);
  life.begin({effect(EffectType::fleet_breakdown, 1.0, false)});
  EXPECT_EQ(life.plant.report().vacant, 2);
  Plan plan = test::hold(1);
  plan.moves = {{.from = 0, .to = 1, .count = 2, .errand = Errand::rebalance}};
  EXPECT_EQ(life.plant.live(&plan).refused, 1);
}

TEST(RegionFaults, DrainedTripsCostMoreAndMayStrand) {
  const World world = two_regions(1);
  const std::vector<Passenger> crossing = {{.appears = 0, .patience = 0, .destination = 1}};
  const auto first_departure = [&](double kwh, const Effect& drain) {
    Life life{plant_of(world, 0, crossing, {car(0, kwh)})};
    return life.next({drain});
  };
  const Departures far = first_departure(10.0, effect(EffectType::fleet_drain, 3.0, false));
  EXPECT_NEAR(far.departures.at(0).vehicle.battery_kwh, 4.0, 1e-9);
  EXPECT_NEAR(far.observed.at(0).amount, 4.0, 1e-9);
  const Departures stranded = first_departure(5.0, effect(EffectType::fleet_drain, 3.0, false));
  EXPECT_EQ(stranded.departures.at(0).vehicle.battery_kwh, 0.0);
  EXPECT_NEAR(stranded.observed.at(0).amount, 3.0, 1e-9);
  EXPECT_TRUE(first_departure(5.0, effect(EffectType::fleet_drain, 3.0, true)).departures.empty())
      << "who is told does not set off on what will not do";
}

TEST(RegionFaults, SlowTripsTakeLonger) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, {{.appears = 0, .patience = 0, .destination = 1}}, {car(0, 10.0)})};
  const Departures said = life.next({effect(EffectType::travel_slow, 1.5)});
  EXPECT_EQ(said.departures.at(0).arrival_minute, 32);
  EXPECT_EQ(said.observed.at(0).amount, 11.0);
  EXPECT_NEAR(said.departures.at(0).vehicle.battery_kwh, 8.0, 1e-9);
}

}  // namespace
}  // namespace evbal

#include "agents/region/region_plant.hpp"

#include "tests/region/plant_fixture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>

namespace evbal {
namespace {

using test::car;
using test::Life;
using test::plant_of;
using test::two_regions;

Effect outage(double points, OnStart on_start, bool visible = true) {
  return {
      .type = EffectType::charger_outage, .region = 0, .magnitude = points, .on_start = on_start, .visible = visible};
}

RC_GTEST_PROP(RegionPlant, ServesWithTheLowestSufficientCharge, ()) {
  const World world = two_regions(1);
  std::vector<Vehicle> cars;
  for (int id = 0; id < *rc::gen::inRange(0, 8); ++id) {
    cars.push_back(car(id, *rc::gen::inRange(0, 80) / 4.0));
  }
  const int destination = *rc::gen::inRange(0, 2);
  const double need = destination == 0 ? 0.4 : 4.0;
  std::optional<Vehicle> expected;
  for (const auto& vehicle : cars) {
    if (vehicle.battery_kwh >= need && (!expected || vehicle.battery_kwh < expected->battery_kwh)) {
      expected = vehicle;
    }
  }
  Life life{plant_of(world, 0, {{.appears = 2, .patience = 0, .destination = destination}}, cars)};
  const Departures said = life.next();
  RC_ASSERT(said.fates.size() == 1U);
  RC_ASSERT(said.fates[0].served == expected.has_value());
  RC_ASSERT(said.fates[0].vehicle == (expected ? expected->id : -1));
  RC_ASSERT(said.departures.size() == (expected ? 1U : 0U));
}

TEST(RegionPlant, ServesFirstComeFirstServedAndLosesTheImpatient) {
  const World world = two_regions(1);
  // Both want to cross; the only car comes at minute 7. The first has gone by then, the third loses to the second.
  const std::vector<Passenger> passengers = {{.appears = 0, .patience = 5, .destination = 1, .index = 0},
                                             {.appears = 1, .patience = 20, .destination = 1, .index = 1},
                                             {.appears = 1, .patience = 6, .destination = 1, .index = 2}};
  Life life{plant_of(world, 0, passengers, {})};
  EXPECT_EQ(life.next().waiting, 3);
  const Departures said = life.next({}, {{.region = 0, .minute = 7, .vehicle = car(9, 10.0)}});
  ASSERT_EQ(said.fates.size(), 3U);
  EXPECT_FALSE(said.fates[0].served);
  EXPECT_EQ(said.fates[0].waited, 5);
  EXPECT_TRUE(said.fates[1].served);
  EXPECT_EQ(said.fates[1].waited, 6);
  EXPECT_EQ(said.fates[1].vehicle, 9);
  EXPECT_FALSE(said.fates[2].served);
  EXPECT_EQ(said.fates[2].waited, 6);
  ASSERT_EQ(said.departures.size(), 1U);
  EXPECT_EQ(said.departures[0].arrival_minute, 7 + 21);
  EXPECT_DOUBLE_EQ(said.departures[0].vehicle.battery_kwh, 8.0);
}

TEST(RegionPlant, AShortTripLastsUntilTheTickEnds) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, {{.appears = 4, .patience = 5, .destination = 0}, {.appears = 5, .patience = 5}},
                     {car(0, 9.0), car(1, 9.5)})};
  const Departures first = life.next();
  ASSERT_EQ(first.departures.size(), 1U);
  EXPECT_EQ(first.departures[0].arrival_minute, 9);
  const Departures second = life.next();
  ASSERT_EQ(second.departures.size(), 1U);
  EXPECT_EQ(second.departures[0].arrival_minute, 10);
}

TEST(RegionPlant, ChargesInTheOrderOfTheQueue) {
  const World world = two_regions(1);
  // All passengers want to cross: below 4 kWh a car is low.
  const std::vector<Passenger> passengers = {{.appears = 600, .patience = 5, .destination = 1}};
  Life life{plant_of(world, 0, passengers, {car(4, 1.0), car(2, 3.0), car(7, 2.0), car(1, 5.0)})};
  std::vector<int> order;
  int completions = 0;
  double charged = 0.0;
  for (int i = 0; i < 7; ++i) {
    const Departures said = life.next();
    completions += said.completions;
    charged += said.charged_kwh;
    for (const auto& session : life.plant.state().sessions) {
      if (order.empty() || order.back() != session.vehicle.id) {
        order.push_back(session.vehicle.id);
        EXPECT_EQ(session.vehicle.sessions, 1);
      }
    }
  }
  EXPECT_EQ(order, (std::vector<int>{4, 2, 7}));
  EXPECT_EQ(completions, 3);
  EXPECT_NEAR(charged, 30.0, 1e-9);
  EXPECT_EQ(life.plant.state().vacant.size(), 4U);
}

TEST(RegionPlant, ACarThatIsStillLowQueuesAgain) {
  World world = two_regions(1);
  world.city.charging.power_kw = 3.0;  // half a kWh a session
  Life life{plant_of(world, 0, {{.appears = 600, .patience = 5, .destination = 1}}, {car(0, 3.2), car(1, 3.6)})};
  life.next();
  life.next();
  const Departures said = life.next();  // the first session ended at minute 10
  EXPECT_EQ(said.completions, 0);
  EXPECT_EQ(life.plant.state().sessions.at(0).vehicle.id, 1);
  EXPECT_EQ(life.plant.state().queue.at(0).id, 0);
  EXPECT_NEAR(life.plant.state().queue.at(0).battery_kwh, 3.7, 1e-9);
}

TEST(RegionPlant, EvictionUnplugsTheLatestToTheHeadOfTheQueue) {
  const World world = two_regions(2);
  Life life{
      plant_of(world, 0, {{.appears = 600, .patience = 5, .destination = 1}}, {car(0, 0.0), car(1, 0.0), car(2, 0.0)})};
  life.next();
  const Departures said = life.next({outage(1.0, OnStart::evict)});
  EXPECT_EQ(said.observed.at(0).evicted, 1);
  EXPECT_EQ(said.observed.at(0).amount, 1.0);
  EXPECT_EQ(said.points, 1);
  EXPECT_EQ(said.plugged, 1);
  EXPECT_EQ(life.plant.state().queue.at(0).id, 1);
  EXPECT_NEAR(life.plant.state().queue.at(0).battery_kwh, 5.0, 1e-9) << "what was charged stays";
  const Departures after = life.next();
  EXPECT_EQ(after.points, 2);
  EXPECT_EQ(after.plugged, 2);
}

TEST(RegionPlant, DrainLetsSessionsEndAndPointsStayShut) {
  const World world = two_regions(2);
  Life life{
      plant_of(world, 0, {{.appears = 600, .patience = 5, .destination = 1}}, {car(0, 0.0), car(1, 0.0), car(2, 0.0)})};
  life.next();
  const Departures during = life.next({outage(2.0, OnStart::drain)});
  EXPECT_EQ(during.plugged, 2);
  EXPECT_EQ(during.points, 2);
  EXPECT_EQ(during.observed.at(0).amount, 0.0);
  const Departures shut = life.next({outage(2.0, OnStart::drain)});
  EXPECT_EQ(shut.plugged, 0);
  EXPECT_EQ(shut.points, 0);
  EXPECT_EQ(shut.observed.at(0).amount, 2.0);
  EXPECT_EQ(shut.completions, 2);
  EXPECT_EQ(shut.queue_minutes, 5);
}

TEST(RegionPlant, ReportsOnlyVisibleFailures) {
  const World world = two_regions(3);
  Life life{plant_of(world, 0, {}, {})};
  life.begin({outage(1.0, OnStart::evict, true), outage(1.0, OnStart::evict, false)});
  EXPECT_EQ(life.plant.report().points, 2);
  EXPECT_EQ(life.plant.live(nullptr).points, 1);
}

TEST(RegionPlant, SendsOffWhatIsThereAndRefusesTheRest) {
  const World world = two_regions(1);
  const std::vector<Passenger> passengers = {{.appears = 600, .patience = 5, .destination = 1}};
  // Region 1: crossing to the station costs 2 kWh, the reserve is 0.4 + 2.
  Life life{plant_of(world, 1, passengers, {car(0, 1.0), car(1, 2.2), car(2, 6.0), car(3, 9.0)})};
  Plan plan = test::hold(0);
  plan.moves = {{.from = 1, .to = 0, .count = 1, .errand = Errand::rebalance},
                {.from = 1, .to = 0, .count = 3, .errand = Errand::charge},
                {.from = 0, .to = 1, .count = 5, .errand = Errand::charge},
                {.from = 1, .to = 7, .count = 4, .errand = Errand::rebalance}};
  const Departures said = life.next({}, {}, &plan);
  ASSERT_EQ(said.departures.size(), 2U);
  EXPECT_EQ(said.departures[0].vehicle.id, 1);
  EXPECT_EQ(said.departures[0].errand, Errand::charge);
  EXPECT_EQ(said.departures[1].vehicle.id, 3);
  EXPECT_EQ(said.departures[1].errand, Errand::rebalance);
  EXPECT_DOUBLE_EQ(said.departures[1].km, 10.0);
  EXPECT_EQ(said.refused, 2 + 4);
  EXPECT_EQ(said.vacant, 1);
  EXPECT_EQ(said.low_battery, 1);
  EXPECT_EQ(said.queue_minutes, 0) << "no station here, hence no queue";
}

TEST(RegionPlant, RefusesAPlanOfAnotherTick) {
  const World world = two_regions(1);
  Life life{plant_of(world, 0, {}, {car(0, 9.0)})};
  Plan plan = test::hold(1);
  plan.moves = {{.from = 0, .to = 1, .count = 2147483647, .errand = Errand::rebalance},
                {.from = 0, .to = 1, .count = 2147483647, .errand = Errand::charge}};
  const Departures said = life.next({}, {}, &plan);
  EXPECT_TRUE(said.departures.empty());
  EXPECT_EQ(said.refused, 2147483647);
}

TEST(RegionPlant, ReportsWhatIsBoundForIt) {
  const World world = two_regions(1);
  RegionPlant plant = plant_of(world, 0, {}, {});
  Tick tick;
  tick.arrivals = {{.region = 0, .minute = 1, .vehicle = car(1, 9.0)},
                   {.region = 0, .minute = 1, .vehicle = car(2, 9.0)},
                   {.region = 1, .minute = 1, .vehicle = car(3, 9.0)}};
  tick.under_way = {{.region = 0, .minute = 8, .errand = Errand::charge, .count = 4},
                    {.region = 1, .minute = 8, .errand = Errand::charge, .count = 5}};
  plant.begin(tick);
  const Report report = plant.report();
  ASSERT_EQ(report.bound.size(), 2U);
  EXPECT_EQ(report.bound[0].count, 2);
  EXPECT_EQ(report.bound[1].count, 4);
  EXPECT_EQ(plant.live(nullptr).vacant, 2);
}

int demand_under(double factor, const World& world, double* observed = nullptr) {
  Life life{plant_of(world, 0, draw_passengers(world, 0), {})};
  const Effect effect{.type = EffectType::demand_scale, .region = 0, .magnitude = factor};
  int demand = 0;
  for (int tick = 0; tick < world.clock.ticks(); ++tick) {
    const Departures said = life.next({effect});
    demand += said.demand;
    if (observed != nullptr) {
      *observed += said.observed.at(0).amount;
    }
  }
  return demand;
}

TEST(RegionPlant, DemandFaultsScaleTheDay) {
  const World world = test::world_of({.regions = 2, .trips_per_day = 4000.0});
  const int base = demand_under(1.0, world);
  EXPECT_EQ(base, static_cast<int>(draw_passengers(world, 0).size()));
  EXPECT_EQ(demand_under(3.0, world), 3 * base);
  EXPECT_EQ(demand_under(0.0, world), 0);
  double observed = 0.0;
  EXPECT_NEAR(demand_under(1.6, world, &observed), 1.6 * base, 0.05 * base);
  EXPECT_NEAR(observed, 0.6 * base, 0.05 * base);
  EXPECT_NEAR(demand_under(0.3, world), 0.3 * base, 0.05 * base);
}

TEST(Draws, FollowTheRecord) {
  World world = test::world_of({.regions = 3, .trips_per_day = 3000.0});
  const auto drawn = [&] {
    int all = 0;
    for (int region = 0; region < 3; ++region) {
      all += static_cast<int>(draw_passengers(world, region).size());
    }
    return all;
  };
  int recorded = 0;
  for (const auto& step : world.day.steps) {
    for (const auto& pair : step) {
      recorded += pair.trips;
    }
  }
  EXPECT_EQ(drawn(), recorded);
  world.demand = DemandModel::poisson;
  EXPECT_NE(drawn(), recorded);
  EXPECT_NEAR(drawn(), recorded, 0.1 * recorded);
  world.clock.start = 20 * 60;
  EXPECT_LT(drawn(), recorded / 2);
}

TEST(Draws, DemandByTickIsWhatAppearsTimesItsFaults) {
  const World world = test::world_of({.regions = 2, .trips_per_day = 2000.0});
  const auto spike = [](int tick) {
    Effect effect{.type = EffectType::demand_scale, .region = 1, .magnitude = 2.5};
    return tick < 20 ? std::vector<Effect>{effect} : std::vector<Effect>{};
  };
  const Eigen::MatrixXd demand = demand_by_tick(world, spike);
  ASSERT_EQ(demand.cols(), world.clock.ticks());
  const auto passengers = draw_passengers(world, 1);
  const auto early = static_cast<double>(std::ranges::count_if(
      passengers, [&](const Passenger& passenger) { return passenger.appears < 20 * world.clock.tick; }));
  EXPECT_GT(early, 0.0);
  EXPECT_NEAR(demand.row(1).head(20).sum(), 2.5 * early, 1e-9);
  EXPECT_NEAR(demand.row(1).sum(), static_cast<double>(passengers.size()) + 1.5 * early, 1e-9);
  EXPECT_NEAR(demand.row(0).sum(), static_cast<double>(draw_passengers(world, 0).size()), 1e-9);
}

TEST(Draws, SessionsFollowTheirQuantiles) {
  World world = two_regions(1);
  world.city.charging.session_quantiles = {10.0, 20.0, 80.0};
  int above_median = 0;
  for (int vehicle = 0; vehicle < 4000; ++vehicle) {
    const int minutes = draw_session(world.city.charging, world.seed, vehicle, 3);
    EXPECT_GE(minutes, 10);
    EXPECT_LE(minutes, 80);
    above_median += minutes > 20 ? 1 : 0;
  }
  EXPECT_NEAR(above_median, 2000, 150);
}

}  // namespace
}  // namespace evbal

// Garbage in any one field of any message: nobody crashes, and no vehicle is made or lost.

#include "agents/protocol/message_check.hpp"
#include "common/error.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"
#include "tests/support/spoilt.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace evbal {
namespace {

/// Says what is true but in one tick, where one field of what somebody says is spoilt.
class GarblingPlayers : public Players {
 public:
  GarblingPlayers(const World& world, const std::vector<Faults>& faults, int spoilt_tick)
      : players_(
            world, [](const Tick& tick, const auto& reports) { return test::wander(7, tick.tick, reports); },
            [&](int tick) { return faults[tick]; }),
        spoilt_tick_(spoilt_tick),
        in_faults_(*rc::gen::inRange(0, 4) == 0) {}

  Faults faults(int tick) override {
    Faults said = players_.faults(tick);
    if (tick == spoilt_tick_ && in_faults_) {
      RC_LOG() << test::spoil_one(said) << " is spoilt";
    }
    return said;
  }

  Exchange play(const Tick& tick) override {
    Exchange said = players_.play(tick);
    if (tick.tick == spoilt_tick_ && !in_faults_) {
      spoil(said);
    }
    return said;
  }

  const std::vector<RegionPlant>& plants() const { return players_.plants(); }

 private:
  static void spoil(Exchange& said) {
    const int whose = *rc::gen::inRange(0, 3);
    if (whose == 0 && said.plan) {
      RC_LOG() << test::spoil_one(*said.plan) << " is spoilt";
    } else if (whose == 1 && !said.reports.empty()) {
      RC_LOG() << test::spoil_one(said.reports) << " is spoilt";
    } else {
      RC_LOG() << test::spoil_one(said.departures) << " is spoilt";
    }
  }

  InprocPlayers players_;
  int spoilt_tick_;
  bool in_faults_;
};

RC_GTEST_PROP(Garbage, EndsTheDayOrChangesNoVehicle, ()) {
  const World world = *test::small_worlds();
  const auto faults = *test::faults_for(world);
  GarblingPlayers players(world, faults, *rc::gen::inRange(0, world.clock.ticks()));
  std::set<int> on_road;
  try {
    run_day(world, players, [&](const TickRecord& record) {
      for (const auto& car : record.tick.arrivals) {
        on_road.erase(car.vehicle.id);
      }
      for (const auto& said : record.exchange.departures) {
        for (const auto& car : said.departures) {
          RC_ASSERT(on_road.insert(car.vehicle.id).second);
        }
      }
    });
  } catch (const Error& error) {
    RC_ASSERT(error.status() == ExitStatus::run_failed);
    return;
  }
  std::size_t vehicles = on_road.size();
  for (const auto& plant : players.plants()) {
    vehicles += plant.census().size();
  }
  RC_ASSERT(vehicles == static_cast<std::size_t>(world.city.fleet.vehicles));
}

/// Vehicles of a region, by id.
std::multiset<int> vehicles_of(const RegionPlant& plant) {
  std::multiset<int> ids;
  for (const auto& place : plant.census()) {
    ids.insert(place.vehicle);
  }
  return ids;
}

RC_GTEST_PROP(Garbage, IsNoReasonForAPlantToLoseVehicles, ()) {
  const World world = *test::small_worlds();
  const auto faults = *test::faults_for(world);
  const int region = *rc::gen::inRange(0, world.city.size());
  const int spoilt_tick = *rc::gen::inRange(0, world.clock.ticks());
  RegionPlant plant(region_worlds(world)[region]);
  InprocPlayers players(
      world, [](const Tick& tick, const auto& reports) { return test::wander(7, tick.tick, reports); },
      [&](int tick) { return faults[tick]; });
  run_day(world, players, [&](const TickRecord& record) {
    if (record.tick.tick > spoilt_tick) {
      return;
    }
    Tick tick = record.tick;
    std::optional<Plan> plan = record.exchange.plan;
    if (tick.tick == spoilt_tick) {
      const bool in_plan = plan && *rc::gen::arbitrary<bool>();
      RC_LOG() << (in_plan ? test::spoil_one(*plan) : test::spoil_one(tick)) << " is spoilt";
    }
    if (!validate(tick, bounds_of(world)).empty()) {
      return;
    }
    std::multiset<int> vehicles = vehicles_of(plant);
    for (const auto& car : tick.arrivals) {
      if (car.region == region) {
        vehicles.insert(car.vehicle.id);
      }
    }
    plant.begin(tick);
    if (tick.plan_due) {
      plant.report();
    }
    const Departures said = plant.live(plan ? &*plan : nullptr);
    for (const auto& car : said.departures) {
      vehicles.erase(vehicles.find(car.vehicle.id));
    }
    RC_ASSERT(vehicles_of(plant) == vehicles);
    RC_ASSERT(said.refused >= 0);
  });
}

TEST(MessageCheck, SaysWhatCannotBe) {
  const World world = test::world_of({});
  const MessageBounds bounds = bounds_of(world);
  const auto of_fault = [&](const Effect& effect) {
    return validate(Faults{.tick = 0, .effects = {effect}, .origin = {}}, bounds);
  };
  EXPECT_EQ(of_fault({.type = EffectType::demand_scale, .region = 4, .magnitude = 2.0}), "");
  EXPECT_EQ(of_fault({.type = EffectType::demand_scale, .region = 5, .magnitude = 2.0}), "region 5");
  EXPECT_EQ(of_fault({.type = EffectType::demand_scale, .magnitude = std::nan("")}), "magnitude nan");
  EXPECT_EQ(of_fault({.type = EffectType::demand_scale, .magnitude = 1e9}), "magnitude 1000000000");
  EXPECT_EQ(of_fault({.type = EffectType::demand_shift, .to = no_region}), "to -1");
  EXPECT_EQ(of_fault({.type = EffectType::sensor_off}), "a sensor of no field");
  EXPECT_EQ(of_fault({.type = EffectType::process_kill, .region = 7, .magnitude = 1.0}), "region 7");
  EXPECT_EQ(of_fault({.type = EffectType::process_kill, .region = no_region, .process = ProcessRole::coordinator}), "");

  const auto of_move = [&](const Move& move) {
    return validate(Plan{.tick = 0, .moves = {move}, .provenance = {}, .origin = {}}, bounds);
  };
  EXPECT_EQ(of_move({.from = 0, .to = 4, .count = 60}), "");
  EXPECT_EQ(of_move({.from = -1, .to = 4, .count = 1}), "from -1");
  EXPECT_EQ(of_move({.from = 0, .to = 4, .count = -1}), "count -1");
  EXPECT_EQ(of_move({.from = 0, .to = 4, .count = 1, .errand = Errand::passenger}), "a move with a passenger");

  const auto of_car = [&](const Departure& car) {
    Departures said;
    said.tick = 1;
    said.departures = {car};
    return validate(said, bounds);
  };
  const Departure sound{.minute = 5, .to = 1, .arrival_minute = 10, .errand = Errand::charge, .vehicle = {}, .km = 1.0};
  Departure car = sound;
  EXPECT_EQ(of_car(car), "");
  car.errand = Errand::passenger;
  EXPECT_EQ(of_car(car), "passengers served and cars that left with one are not the same");
  car = sound;
  car.arrival_minute = 9;
  EXPECT_EQ(of_car(car), "arrival_minute 9");
  car.arrival_minute = std::numeric_limits<int>::max();
  EXPECT_EQ(of_car(car), "arrival_minute 2147483647");
  car = sound;
  car.vehicle.battery_kwh = std::nan("");
  EXPECT_EQ(of_car(car), "battery_kwh nan");

  Tick tick;
  tick.arrivals = {{.region = 0, .minute = 0, .vehicle = {.id = 3}}, {.region = 1, .minute = 4, .vehicle = {.id = 3}}};
  EXPECT_EQ(validate(tick, bounds), "vehicle 3 twice");
  tick.arrivals.pop_back();
  EXPECT_EQ(validate(tick, bounds), "");
  tick.tick = bounds.clock.ticks();
  EXPECT_EQ(validate(tick, bounds), "tick 228");
}

RC_GTEST_PROP(MessageCheck, AcceptsWhatIsSaidInADay, ()) {
  const World world = *test::small_worlds();
  const auto faults = *test::faults_for(world);
  const MessageBounds bounds = bounds_of(world);
  InprocPlayers players(
      world, [](const Tick& tick, const auto& reports) { return test::wander(7, tick.tick, reports); },
      [&](int tick) { return faults[tick]; });
  run_day(world, players, [&](const TickRecord& record) { RC_ASSERT(validate(record.tick, bounds) == ""); });
}

}  // namespace
}  // namespace evbal

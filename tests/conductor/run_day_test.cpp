#include "experiments/conductor/run_day.hpp"

#include "agents/protocol/fingerprint.hpp"
#include "agents/region/region_plant.hpp"
#include "coordinator/balancing/round_to_vehicles.hpp"
#include "coordinator/planning/planning_data.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/roads.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

using test::faults_for;
using test::hold;
using test::no_faults;
using test::small_worlds;

std::vector<TickRecord> play(const World& world, Players& players) {
  std::vector<TickRecord> records;
  run_day(world, players, [&](const TickRecord& record) { records.push_back(record); });
  return records;
}

std::vector<TickRecord> wander_through(const World& world, const std::vector<Faults>& faults, std::uint64_t seed) {
  InprocPlayers players(
      world, [=](const Tick& tick, const auto& reports) { return test::wander(seed, tick.tick, reports); },
      [&](int tick) { return faults[tick]; });
  return play(world, players);
}

std::string fingerprint_of(const std::vector<TickRecord>& records) {
  Digest digest;
  for (const auto& record : records) {
    for (const auto& report : record.exchange.reports) {
      fingerprint(digest, report);
    }
    for (const auto& departures : record.exchange.departures) {
      fingerprint(digest, departures);
    }
  }
  return digest.hex();
}

/// Gives the plants plans that make no sense, and shows the conductor empty ones, whose check would refuse them.
class RavingPlayers : public Players {
 public:
  RavingPlayers(const World& world, const std::vector<Faults>& faults, std::uint64_t seed)
      : players_(
            world, [=](const Tick& tick, const auto& reports) { return test::rave(seed, tick.tick, reports); },
            [&](int tick) { return faults[tick]; }) {}

  Faults faults(int tick) override { return players_.faults(tick); }

  Exchange play(const Tick& tick) override {
    Exchange said = players_.play(tick);
    if (said.plan) {
      said.plan->moves.clear();
    }
    return said;
  }

 private:
  InprocPlayers players_;
};

// run_day itself checks vehicles and points at every tick and throws.
RC_GTEST_PROP(RunDay, ConservesVehiclesAndPoints, ()) {
  const World world = *small_worlds();
  const auto faults = *faults_for(world);
  RC_ASSERT(wander_through(world, faults, 1).size() == static_cast<std::size_t>(world.clock.ticks()));
}

RC_GTEST_PROP(RunDay, SurvivesAbsurdPlans, ()) {
  const World world = *small_worlds();
  const auto faults = *faults_for(world);
  RavingPlayers players(world, faults, 1);
  for (const auto& record : play(world, players)) {
    for (const auto& departures : record.exchange.departures) {
      RC_ASSERT(departures.refused >= 0);
    }
  }
}

/// Sends low-battery cars anywhere, as many as get there by what the reports say.
Plan within_reach(const City& city, std::uint64_t seed, int tick, const std::vector<Report>& reports) {
  RandomStream random(seed, Purpose::bootstrap, {.tick = static_cast<std::uint64_t>(tick)});
  const FleetState state = fleet_state(reports, 0, 30, 1);
  std::vector<Flow> flows;
  std::vector<Arc> arcs;
  for (int from = 0; from < city.size(); ++from) {
    for (int to = 0; to < city.size(); ++to) {
      if (from != to) {
        flows.push_back({from, to, random.uniform(0.0, 2.0)});
        arcs.push_back({from, to, city.km(from, to)});
      }
    }
  }
  Plan plan = hold(tick);
  for (const auto& flow : round_to_vehicles(flows, state.low_battery.cast<int>(), reach_limits(state, arcs))) {
    plan.moves.push_back({flow.from, flow.to, flow.vehicles, Errand::charge});
  }
  return plan;
}

RC_GTEST_PROP(RunDay, RefusesNobodyWithinReach, ()) {
  const World world = *small_worlds();
  const auto faults = *faults_for(world);
  InprocPlayers players(
      world, [&](const Tick& tick, const auto& reports) { return within_reach(world.city, 9, tick.tick, reports); },
      [&](int tick) { return faults[tick]; });
  for (const auto& record : play(world, players)) {
    for (const auto& said : record.exchange.departures) {
      RC_ASSERT(said.refused == 0);
    }
  }
}

RC_GTEST_PROP(RunDay, SettlesEveryPassengerOnce, ()) {
  const World world = *small_worlds();
  const auto faults = *faults_for(world);
  const auto records = wander_through(world, faults, 2);
  const int patience = static_cast<int>(std::lround(world.city.passengers.patience_high));
  for (int region = 0; region < world.city.size(); ++region) {
    int appeared = 0;
    int settled = 0;
    for (const auto& record : records) {
      const Departures& said = record.exchange.departures[region];
      appeared += said.demand;
      settled += static_cast<int>(said.fates.size());
      RC_ASSERT(appeared == settled + said.waiting);
      const auto served = std::count_if(said.fates.begin(), said.fates.end(), [](const Fate& f) { return f.served; });
      const auto rides = std::count_if(said.departures.begin(), said.departures.end(),
                                       [](const Departure& d) { return d.errand == Errand::passenger; });
      RC_ASSERT(served == rides);
      for (const auto& fate : said.fates) {
        RC_ASSERT(fate.waited >= 0);
        RC_ASSERT(fate.waited <= patience);
        RC_ASSERT(fate.served == (fate.vehicle >= 0));
      }
    }
  }
}

RC_GTEST_PROP(RunDay, SettlesThePassengersThatWereDrawn, ()) {
  const World world = *small_worlds();
  const auto records = wander_through(world, std::vector<Faults>(world.clock.ticks()), 3);
  for (int region = 0; region < world.city.size(); ++region) {
    std::multiset<std::pair<int, int>> expected;
    for (const auto& passenger : draw_passengers(world, region)) {
      expected.emplace(passenger.appears, passenger.destination);
    }
    for (const auto& record : records) {
      for (const auto& fate : record.exchange.departures[region].fates) {
        const auto passenger = expected.find({fate.appeared, fate.destination});
        RC_ASSERT(passenger != expected.end());
        expected.erase(passenger);
      }
    }
    RC_ASSERT(static_cast<int>(expected.size()) == records.back().exchange.departures[region].waiting);
  }
}

RC_GTEST_PROP(RunDay, KeepsBatteriesWithinBounds, ()) {
  const World world = *small_worlds();
  for (const auto& record : wander_through(world, *faults_for(world), 4)) {
    for (const auto& departures : record.exchange.departures) {
      for (const auto& car : departures.departures) {
        RC_ASSERT(car.vehicle.battery_kwh >= 0.0);
        RC_ASSERT(car.vehicle.battery_kwh <= world.city.fleet.battery_kwh);
        RC_ASSERT(car.arrival_minute > car.minute);
      }
    }
  }
}

// Under any fault of the world, slow traffic too: minutes of arrival need no law of errors.
RC_GTEST_PROP(RunDay, LetsVehiclesArriveInTheMinuteThatWasReported, ()) {
  const World world = *small_worlds();
  std::map<int, std::pair<int, int>> due;  // region and minute, by vehicle
  for (const auto& record : wander_through(world, *faults_for(world), 8)) {
    for (const Arrival& arrival : record.tick.arrivals) {
      const auto told = due.find(arrival.vehicle.id);
      const bool as_told =
          told == due.end() ? record.tick.tick == 0 : told->second == std::pair(arrival.region, arrival.minute);
      RC_ASSERT(as_told);
    }
    for (const auto& departures : record.exchange.departures) {
      for (const Departure& car : departures.departures) {
        due[car.vehicle.id] = {car.to, car.arrival_minute};
      }
    }
  }
}

RC_GTEST_PROP(RunDay, CountsEveryVehicleInReports, ()) {
  const World world = *small_worlds();
  for (const auto& record : wander_through(world, *faults_for(world), 5)) {
    int vehicles = 0;
    int broken = 0;
    for (const auto& said : record.exchange.departures) {
      broken += said.broken;
    }
    for (const auto& report : record.exchange.reports) {
      vehicles += report.vacant + report.low_battery + report.plugged;
      for (const auto& cars : report.bound) {
        vehicles += cars.count;
      }
    }
    RC_ASSERT(record.exchange.reports.empty() || vehicles <= world.city.fleet.vehicles);
    RC_ASSERT(record.exchange.reports.empty() || vehicles + broken >= world.city.fleet.vehicles);
  }
}

// Whoever observes a day can follow every vehicle: the plants' census, and that of roads of one's own.
RC_GTEST_PROP(RunDay, ShowsEveryVehicleInOnePlace, ()) {
  const World world = *small_worlds();
  const auto faults = *faults_for(world);
  InprocPlayers players(
      world, [](const Tick& tick, const auto& reports) { return test::wander(7, tick.tick, reports); },
      [&](int tick) { return faults[tick]; });
  Roads roads(draw_fleet(world));
  run_day(world, players, [&](const TickRecord& record) {
    const int ends = world.clock.minute_of(record.tick.tick + 1);
    roads.hand_out(ends);
    std::multiset<int> seen;
    for (const auto& departures : record.exchange.departures) {
      roads.take(departures, ends);
    }
    for (const auto& place : roads.census()) {
      seen.insert(place.vehicle);
    }
    for (const auto& plant : players.plants()) {
      for (const auto& place : plant.census()) {
        seen.insert(place.vehicle);
      }
    }
    RC_ASSERT(static_cast<int>(seen.size()) == world.city.fleet.vehicles);
    for (int id = 0; id < world.city.fleet.vehicles; ++id) {
      RC_ASSERT(seen.count(id) == 1U);
    }
  });
}

// Cars that were in the queue and are not there any more were its first ones, unless a plan took them; here none does.
RC_GTEST_PROP(RunDay, PlugsInFirstComeFirstServed, ()) {
  const World world = *small_worlds();
  InprocPlayers players(
      world, [](const Tick& tick, const auto&) { return hold(tick.tick); }, no_faults);
  std::vector<std::vector<Vehicle>> before(world.city.size());
  run_day(world, players, [&](const TickRecord&) {
    for (const auto& plant : players.plants()) {
      std::vector<Vehicle>& queue = before[plant.region()];
      const auto& now = plant.state().queue;
      const auto still = [&](const Vehicle& car) {
        return std::any_of(now.begin(), now.end(),
                           [&](const Vehicle& other) { return other.id == car.id && other.sessions == car.sessions; });
      };
      RC_ASSERT(std::is_partitioned(queue.begin(), queue.end(), [&](const Vehicle& car) { return !still(car); }));
      queue.assign(now.begin(), now.end());
    }
  });
}

RC_GTEST_PROP(RunDay, SaysTheSameTwice, ()) {
  const World world = *small_worlds();
  const auto faults = *faults_for(world);
  RC_ASSERT(fingerprint_of(wander_through(world, faults, 6)) == fingerprint_of(wander_through(world, faults, 6)));
}

World busy_day(int tick) {
  SyntheticOptions options;
  options.regions = 9;
  options.trips_per_day = 6000.0;
  options.vehicles = 140;
  options.stations = 4;
  options.points = 16;
  return test::world_of(options, {.tick = tick, .plan_every = 10});
}

/// Low-battery cars to the nearest station, else nothing.
Plan to_nearest_station(const City& city, int tick, const std::vector<Report>& reports) {
  Plan plan = hold(tick);
  const std::vector<int> station = city.nearest_station();
  for (const auto& report : reports) {
    if (report.low_battery > 0 && station[report.region] != report.region) {
      plan.moves.push_back({report.region, station[report.region], report.low_battery, Errand::charge});
    }
  }
  return plan;
}

std::pair<int, int> served_and_lost(const World& world) {
  InprocPlayers players(
      world, [&](const Tick& tick, const auto& reports) { return to_nearest_station(world.city, tick.tick, reports); },
      no_faults);
  int served = 0;
  int lost = 0;
  for (const auto& record : play(world, players)) {
    for (const auto& departures : record.exchange.departures) {
      for (const auto& fate : departures.fates) {
        ++(fate.served ? served : lost);
      }
    }
  }
  return {served, lost};
}

TEST(RunDay, HalvingTheTickHardlyChangesTheDay) {
  const auto [served, lost] = served_and_lost(busy_day(10));
  const auto [served_half, lost_half] = served_and_lost(busy_day(5));
  EXPECT_GT(lost, served / 20) << "nothing is scarce: the comparison would show nothing";
  EXPECT_NEAR(served_half, served, 0.02 * served);
}

TEST(RunDay, AnotherSeedGivesAnotherDay) {
  World world = busy_day(5);
  const std::vector<Faults> faults(world.clock.ticks());
  const std::string first = fingerprint_of(wander_through(world, faults, 1));
  ++world.seed;
  EXPECT_NE(first, fingerprint_of(wander_through(world, faults, 1)));
}

}  // namespace
}  // namespace evbal

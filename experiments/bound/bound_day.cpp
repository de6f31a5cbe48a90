#include "experiments/bound/bound_day.hpp"

#include "agents/world/draws.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"
#include "faults/schedule/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

std::vector<BoundPassenger> lost_without_cars(World world, const std::function<Faults(int tick)>& faults) {
  world.city.fleet.vehicles = 0;
  InprocPlayers players(
      world,
      [](const Tick& tick, const std::vector<Report>&) {
        Plan plan;
        plan.tick = tick.tick;
        return plan;
      },
      faults);
  std::vector<BoundPassenger> passengers;
  run_day(world, players, [&](const TickRecord& record) {
    for (const Departures& said : record.exchange.departures) {
      for (const Fate& fate : said.fates) {
        passengers.push_back({.origin = said.region,
                              .destination = fate.destination,
                              .appears = fate.appeared,
                              .last = fate.appeared + fate.waited});
      }
    }
  });
  return passengers;
}

}  // namespace

BoundDay bound_day(const World& world, const std::function<Faults(int tick)>& faults) {
  const City& city = world.city;
  BoundDay day{
      .ticks = world.clock.ticks(),
      .tick = world.clock.tick,
      .step = world.clock.step,
      .km = city.km,
      .minutes = city.minutes.unaryExpr([](double minutes) { return std::max(1.0, std::ceil(minutes)); }).cast<int>(),
      .cars = {},
      .passengers = lost_without_cars(world, faults)};
  for (const auto& vehicles : draw_fleet(world)) {
    day.cars.push_back(static_cast<int>(vehicles.size()));
  }
  return day;
}

BoundDay bound_day(const Scenario& scenario) {
  return bound_day(scenario.world, [&](int tick) { return faults_at(scenario.schedule, scenario.world.clock, tick); });
}

}  // namespace evbal

#pragma once

#include "agents/region/region_plant.hpp"
#include "tests/support/worlds.hpp"

#include <utility>
#include <vector>

namespace evbal::test {

/// Two regions, a station in region 0, no recorded demand: each test brings its own cars and passengers.
inline World two_regions(int points) {
  World world = world_of({.regions = 2, .trips_per_day = 0.0, .vehicles = 0, .stations = 1, .points = points});
  world.city.km << 2.0, 10.0, 10.0, 2.0;
  world.city.minutes << 5.0, 20.5, 20.5, 5.0;
  world.city.fleet.battery_kwh = 20.0;
  world.city.fleet.km_per_kwh = 5.0;  // 0.4 kWh within, 2 kWh across, 4 kWh across and back
  world.city.charging = {.power_kw = 60.0, .session_quantiles = {10.0, 10.0}};
  return world;
}

inline Vehicle car(int id, double kwh) {
  return {.id = id, .sessions = 0, .battery_kwh = kwh};
}

/// The plant of a region with the passengers and cars of a test.
inline RegionPlant plant_of(const World& world, int region, std::vector<Passenger> passengers,
                            std::vector<Vehicle> vehicles) {
  RegionWorld own = region_worlds(world)[static_cast<std::size_t>(region)];
  own.passengers = std::move(passengers);
  own.vehicles = std::move(vehicles);
  return RegionPlant(std::move(own));
}

/// Lives through tick after tick.
struct Life {
  RegionPlant plant;
  int tick = 0;

  Departures next(std::vector<Effect> effects = {}, std::vector<Arrival> arrivals = {}, const Plan* plan = nullptr) {
    begin(std::move(effects), std::move(arrivals));
    return plant.live(plan);
  }

  void begin(std::vector<Effect> effects = {}, std::vector<Arrival> arrivals = {}) {
    Tick next;
    next.tick = tick++;
    next.effects = std::move(effects);
    next.arrivals = std::move(arrivals);
    plant.begin(next);
  }
};

}  // namespace evbal::test

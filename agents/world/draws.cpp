#include "agents/world/draws.hpp"

#include "common/random.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace evbal {
namespace {

std::uint64_t key(int number) {
  return static_cast<std::uint64_t>(number);
}

/// Trips of one pair and step as they happen under the world's demand model.
int trips_of(const World& world, int step, const TripCount& pair) {
  if (world.demand == DemandModel::recorded) {
    return pair.trips;
  }
  RandomStream stream(world.seed, Purpose::poisson_demand,
                      {.region = key(pair.origin), .tick = key(step), .index = key(pair.destination)});
  return static_cast<int>(stream.poisson(pair.trips));
}

/// The `number`-th passenger of one pair and step. Keyed by all of these, so that nobody depends on how many others
/// there are.
Passenger passenger_of(const World& world, int step, const TripCount& pair, int number) {
  RandomStream stream(
      world.seed, Purpose::passenger,
      {.region = key(pair.origin), .tick = key(step), .index = (key(pair.destination) << 32U) + key(number)});
  const int step_starts = world.city.day_start - world.clock.start + step * world.city.step_minutes;
  const int minute = step_starts + static_cast<int>(stream.below(key(world.city.step_minutes)));
  return {.appears = minute,
          .patience = draw_patience(world.city.passengers, stream.uniform()),
          .destination = pair.destination};
}

}  // namespace

int draw_patience(const PassengerAssumption& passengers, double uniform) {
  const double minutes = passengers.patience_low + (passengers.patience_high - passengers.patience_low) * uniform;
  return static_cast<int>(std::lround(minutes));
}

std::vector<Passenger> draw_passengers(const World& world, int region) {
  std::vector<Passenger> passengers;
  for (int step = 0; step < static_cast<int>(world.day.steps.size()); ++step) {
    for (const auto& pair : world.day.steps[step]) {
      if (pair.origin != region) {
        continue;
      }
      const int trips = trips_of(world, step, pair);
      for (int number = 0; number < trips; ++number) {
        const Passenger passenger = passenger_of(world, step, pair, number);
        if (passenger.appears >= 0 && passenger.appears < world.clock.minutes()) {
          passengers.push_back(passenger);
        }
      }
    }
  }
  std::stable_sort(passengers.begin(), passengers.end(), [](const Passenger& a, const Passenger& b) {
    return std::tie(a.appears, a.destination, a.patience) < std::tie(b.appears, b.destination, b.patience);
  });
  for (int i = 0; i < static_cast<int>(passengers.size()); ++i) {
    passengers[i].index = i;
  }
  return passengers;
}

Eigen::MatrixXd demand_by_tick(const World& world, const std::function<std::vector<Effect>(int tick)>& effects) {
  Eigen::MatrixXd demand = Eigen::MatrixXd::Zero(world.city.size(), world.clock.ticks());
  for (int region = 0; region < world.city.size(); ++region) {
    for (const Passenger& passenger : draw_passengers(world, region)) {
      demand(region, passenger.appears / world.clock.tick) += 1.0;
    }
  }
  for (int tick = 0; tick < world.clock.ticks(); ++tick) {
    const std::vector<Effect> active = effects(tick);
    for (const Effect& effect : active) {
      if (effect.type == EffectType::demand_scale) {
        demand(effect.region, tick) *= effect.magnitude;
      }
    }
    for (const Effect& effect : active) {
      if (effect.type == EffectType::demand_add) {
        demand(effect.region, tick) += effect.magnitude / 60.0 * world.clock.tick;
      }
    }
  }
  return demand;
}

std::vector<std::vector<Vehicle>> draw_fleet(const World& world) {
  const FleetAssumption& fleet = world.city.fleet;
  std::vector<double> pick_ups(world.city.regions.size(), 0.0);
  for (const auto& step : world.day.steps) {
    for (const auto& pair : step) {
      pick_ups[pair.origin] += pair.trips;
    }
  }
  if (std::all_of(pick_ups.begin(), pick_ups.end(), [](double trips) { return trips == 0.0; })) {
    std::fill(pick_ups.begin(), pick_ups.end(), 1.0);
  }
  std::vector<std::vector<Vehicle>> by_region(world.city.regions.size());
  for (int id = 0; id < fleet.vehicles; ++id) {
    RandomStream stream(world.seed, Purpose::fleet, {.index = key(id)});
    const std::size_t drawn = stream.weighted(pick_ups);
    const std::size_t region = fleet.placement == FleetPlacement::even ? id % pick_ups.size() : drawn;
    const double charge = stream.uniform(fleet.initial_charge_low, fleet.initial_charge_high);
    by_region[region].push_back({.id = id, .sessions = 0, .battery_kwh = charge * fleet.battery_kwh});
  }
  return by_region;
}

int draw_session(const ChargingAssumption& charging, std::uint64_t seed, int vehicle, int session) {
  const std::vector<double>& quantiles = charging.session_quantiles;
  RandomStream stream(seed, Purpose::session, {.tick = key(session), .index = key(vehicle)});
  const double position = stream.uniform() * static_cast<double>(quantiles.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const double share = position - static_cast<double>(below);
  const double minutes = quantiles[below] + share * (quantiles[below + 1] - quantiles[below]);
  return std::max(1, static_cast<int>(std::lround(minutes)));
}

}  // namespace evbal

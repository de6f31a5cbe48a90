#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/world/synthetic.hpp"
#include "agents/world/world.hpp"
#include "common/random.hpp"

#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace evbal::test {

inline World world_of(const SyntheticOptions& options, const DayClock& clock = {}, std::uint64_t seed = 7) {
  SyntheticCity synthetic = synthetic_city(options);
  World world;
  world.city = std::move(synthetic.city);
  world.day = std::move(synthetic.days.front());
  world.clock = clock;
  world.seed = seed;
  return world;
}

/// A few regions for a few hours: from no vehicles to plenty, from no station to many, from long to short ticks.
inline rc::Gen<World> small_worlds() {
  return rc::gen::exec([] {
    SyntheticOptions options;
    options.regions = *rc::gen::inRange(1, 7);
    options.train_days = 1;
    options.test_days = 0;
    options.seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
    options.trips_per_day = *rc::gen::inRange(0, 2000);
    options.vehicles = *rc::gen::inRange(0, 50);
    options.battery_kwh = *rc::gen::inRange(2, 40);
    options.stations = *rc::gen::inRange(0, options.regions + 1);
    options.points = options.stations + *rc::gen::inRange(0, 5);
    DayClock clock{.start = 7 * 60, .end = 11 * 60};
    clock.tick = *rc::gen::element(1, 2, 5, 10, 30);
    clock.plan_every = clock.tick * *rc::gen::element(1, 30 / clock.tick);
    World world = world_of(options, clock, *rc::gen::inRange<std::uint64_t>(0, 1000));
    world.demand = *rc::gen::element(DemandModel::recorded, DemandModel::poisson);
    world.city.passengers = {.patience_low = 1.0, .patience_high = 12.0};
    world.city.fleet.initial_charge_low = 0.0;
    world.city.charging.top_up = *rc::gen::arbitrary<bool>();
    return world;
  });
}

/// Up to six faults of the world with random windows, regions and magnitudes, some of them absurdly large.
inline rc::Gen<std::vector<Faults>> faults_for(const World& world) {
  return rc::gen::exec([world] {
    std::vector<Faults> by_tick(world.clock.ticks());
    for (int tick = 0; tick < world.clock.ticks(); ++tick) {
      by_tick[tick].tick = tick;
    }
    const int count = *rc::gen::inRange(0, 7);
    for (int fault = 0; fault < count; ++fault) {
      Effect effect;
      effect.fault = fault;
      const int type = *rc::gen::inRange(0, static_cast<int>(EffectType::travel_slow) + 2);
      effect.type = type > static_cast<int>(EffectType::travel_slow) ? EffectType::charger_no_start
                                                                     : static_cast<EffectType>(type);
      effect.region = *rc::gen::inRange(0, world.city.size());
      effect.to = effect.type == EffectType::demand_shift ? *rc::gen::inRange(0, world.city.size()) : no_region;
      const bool counts = effect.type == EffectType::charger_outage || effect.type == EffectType::charger_block ||
                          effect.type == EffectType::fleet_breakdown;
      effect.magnitude = counts ? *rc::gen::inRange(0, 8) : *rc::gen::inRange(0, 40) / 10.0;
      effect.on_start = *rc::gen::element(OnStart::drain, OnStart::evict);
      effect.visible = *rc::gen::arbitrary<bool>();
      const int first = *rc::gen::inRange(0, world.clock.ticks());
      const int last = std::min(world.clock.ticks(), first + *rc::gen::inRange(1, world.clock.ticks() + 1));
      for (int tick = first; tick < last; ++tick) {
        by_tick[tick].effects.push_back(effect);
      }
    }
    return by_tick;
  });
}

/// Moves at random what the reports offer, never more.
inline Plan wander(std::uint64_t seed, int tick, const std::vector<Report>& reports) {
  RandomStream random(seed, Purpose::bootstrap, {.tick = static_cast<std::uint64_t>(tick)});
  Plan plan;
  plan.tick = tick;
  for (const auto& report : reports) {
    int vacant = report.vacant;
    for (const Errand errand : {Errand::rebalance, Errand::charge}) {
      const int to = static_cast<int>(random.below(reports.size()));
      const bool stays = errand == Errand::charge && to == report.region;
      const int there = errand == Errand::rebalance ? vacant
                        : stays                     ? std::min(vacant, report.chargeable)
                                                    : report.low_battery;
      const int count = static_cast<int>(random.below(static_cast<std::uint64_t>(there) + 1));
      vacant -= errand == Errand::rebalance ? count : 0;
      if (count > 0) {
        plan.moves.push_back({.from = report.region, .to = to, .count = count, .errand = errand});
      }
    }
  }
  return plan;
}

/// Orders that no region could follow: too many cars, to nowhere, from nowhere, of no sense.
inline Plan rave(std::uint64_t seed, int tick, const std::vector<Report>& reports) {
  RandomStream random(seed, Purpose::bootstrap, {.tick = static_cast<std::uint64_t>(tick)});
  Plan plan;
  plan.tick = tick;
  const auto regions = static_cast<std::uint64_t>(reports.size()) + 4;
  for (int i = 0; i < 12; ++i) {
    plan.moves.push_back({.from = static_cast<int>(random.below(regions)) - 2,
                          .to = static_cast<int>(random.below(regions)) - 2,
                          .count = static_cast<int>(random.below(200)) - 50,
                          .errand = static_cast<Errand>(random.below(3))});
  }
  return plan;
}

inline Plan hold(int tick) {
  Plan plan;
  plan.tick = tick;
  return plan;
}

inline Faults no_faults(int tick) {
  Faults faults;
  faults.tick = tick;
  return faults;
}

}  // namespace evbal::test

#include "agents/region/region_plant.hpp"
#include "agents/region/size_of.hpp"

#include <algorithm>
#include <cmath>

// What faults do to a region (docs/faults.md), but for its passengers.

namespace evbal {
namespace {

int whole(const Effect& effect) {
  return static_cast<int>(std::lround(effect.magnitude));
}

int points_failing(const Effect& effect) {
  return effect.type == EffectType::charger_outage ? whole(effect) : 0;
}

}  // namespace

double RegionPlant::factor(EffectType type, bool visible_only) const {
  double product = 1.0;
  for (const auto& effect : incoming_.effects) {
    if (effect.type == type && (effect.visible || !visible_only)) {
      product *= effect.magnitude;
    }
  }
  return product;
}

void RegionPlant::observe(EffectType type, double amount) {
  for (std::size_t i = 0; i < incoming_.effects.size(); ++i) {
    if (incoming_.effects[i].type == type) {
      said_.observed[i].amount += amount;
      return;
    }
  }
}

int RegionPlant::points_left(bool visible_only) const {
  int left = world_.points;
  for (const auto& effect : incoming_.effects) {
    left -= effect.visible || !visible_only ? points_failing(effect) : 0;
  }
  return std::max(0, left);
}

int RegionPlant::working_points(bool visible_only) const {
  return std::max(points_left(visible_only), size_of(state_.sessions));
}

int RegionPlant::points_blocked(bool visible_only) const {
  int blocked = 0;
  for (const auto& effect : incoming_.effects) {
    const bool told = effect.visible || !visible_only;
    blocked += effect.type == EffectType::charger_block && told ? whole(effect) : 0;
  }
  return blocked;
}

bool RegionPlant::starts(const Vehicle& vehicle, int minute) {
  RandomStream stream(world_.seed, Purpose::session_start,
                      {.region = static_cast<std::uint64_t>(world_.region),
                       .tick = static_cast<std::uint64_t>(minute),
                       .index = static_cast<std::uint64_t>(vehicle.id)});
  for (std::size_t i = 0; i < incoming_.effects.size(); ++i) {
    const Effect& effect = incoming_.effects[i];
    if (effect.type == EffectType::charger_no_start && stream.uniform() < effect.magnitude) {
      said_.observed[i].amount += 1.0;
      return false;
    }
  }
  return true;
}

void RegionPlant::fail_points() {
  int left = world_.points;
  for (std::size_t i = 0; i < incoming_.effects.size(); ++i) {
    if (incoming_.effects[i].on_start != OnStart::evict) {
      continue;
    }
    left = std::max(0, left - points_failing(incoming_.effects[i]));
    while (size_of(state_.sessions) > left) {
      state_.queue.push_front(state_.sessions.back().vehicle);
      state_.sessions.pop_back();
      ++said_.observed[i].evicted;
    }
  }
}

void RegionPlant::count_points() {
  int closed = world_.points - working_points(false);
  int free = working_points(false) - size_of(state_.sessions);
  for (std::size_t i = 0; i < incoming_.effects.size(); ++i) {
    const Effect& effect = incoming_.effects[i];
    int& pool = effect.type == EffectType::charger_block ? free : closed;
    const int share = std::min(pool, effect.type == EffectType::charger_block ? whole(effect) : points_failing(effect));
    said_.observed[i].amount += share;
    pool -= share;
  }
}

void RegionPlant::mend() {
  const auto lasts = [&](const BrokenDown& broken) {
    return std::any_of(incoming_.effects.begin(), incoming_.effects.end(), [&](const Effect& effect) {
      return effect.type == EffectType::fleet_breakdown && effect.fault == broken.fault;
    });
  };
  const auto mended = std::stable_partition(state_.broken.begin(), state_.broken.end(), lasts);
  for (auto broken = mended; broken != state_.broken.end(); ++broken) {
    settle(broken->vehicle);
  }
  state_.broken.erase(mended, state_.broken.end());
}

void RegionPlant::break_down() {
  for (std::size_t i = 0; i < incoming_.effects.size(); ++i) {
    const Effect& effect = incoming_.effects[i];
    if (effect.type != EffectType::fleet_breakdown) {
      continue;
    }
    auto out = std::count_if(state_.broken.begin(), state_.broken.end(),
                             [&](const BrokenDown& broken) { return broken.fault == effect.fault; });
    RandomStream stream(world_.seed, Purpose::breakdown,
                        {.region = static_cast<std::uint64_t>(world_.region),
                         .tick = static_cast<std::uint64_t>(said_.tick),
                         .index = static_cast<std::uint64_t>(effect.fault)});
    for (; out < whole(effect) && !state_.vacant.empty(); ++out) {
      const auto hit = state_.vacant.begin() + static_cast<std::ptrdiff_t>(stream.below(state_.vacant.size()));
      state_.broken.push_back({*hit, effect.fault});
      state_.vacant.erase(hit);
    }
    said_.observed[i].amount = static_cast<double>(out);
  }
}

std::vector<Vehicle> RegionPlant::vacant_as_told() const {
  std::vector<Vehicle> vacant = state_.vacant;
  for (const auto& effect : incoming_.effects) {
    for (const auto& broken : state_.broken) {
      if (effect.type == EffectType::fleet_breakdown && !effect.visible && broken.fault == effect.fault) {
        vacant.push_back(broken.vehicle);
      }
    }
  }
  return vacant;
}

}  // namespace evbal

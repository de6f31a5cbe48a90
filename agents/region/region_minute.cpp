#include "agents/region/region_plant.hpp"
#include "agents/region/size_of.hpp"
#include "common/random.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

// What happens in a minute of a region, in the order of live_minute.

namespace evbal {
namespace {

/// That a session which does not start keeps its point: to plug in, pay, wait and give up.
constexpr int minutes_of_a_try = 5;

bool less_charge(const Vehicle& a, const Vehicle& b) {
  return std::tie(a.battery_kwh, a.id) < std::tie(b.battery_kwh, b.id);
}

}  // namespace

void RegionPlant::live_minute(int minute) {
  arrive(minute);
  end_sessions(minute);
  plug_in(minute);
  appear(minute);
  serve_or_lose(minute);
  charge();
}

void RegionPlant::arrive(int minute) {
  for (const auto& arrival : incoming_.arrivals) {
    if (arrival.minute != minute) {
      continue;
    }
    said_.stranded += arrival.vehicle.battery_kwh <= 0.0 ? 1 : 0;
    if (arrival.errand == Errand::charge) {
      state_.queue.push_back(arrival.vehicle);
    } else {
      settle(arrival.vehicle);
    }
  }
}

void RegionPlant::end_sessions(int minute) {
  const auto goes_on = [&](const Session& session) { return session.ends > minute; };
  const auto ended = std::stable_partition(state_.sessions.begin(), state_.sessions.end(), goes_on);
  for (auto session = ended; session != state_.sessions.end(); ++session) {
    if (!session->started) {
      state_.queue.push_front(session->vehicle);
      continue;
    }
    const int charged = session->vehicle.battery_kwh >= reserve_kwh_ ? 1 : 0;
    said_.completions += charged;
    state_.completions += charged;
    settle(session->vehicle);
  }
  state_.sessions.erase(ended, state_.sessions.end());
}

void RegionPlant::plug_in(int minute) {
  const int left = points_left(false) - points_blocked(false);
  while (!state_.queue.empty() && size_of(state_.sessions) < left) {
    Vehicle vehicle = state_.queue.front();
    state_.queue.pop_front();
    if (!starts(vehicle, minute)) {
      state_.sessions.push_back(
          {.vehicle = vehicle, .since = minute, .ends = minute + minutes_of_a_try, .started = false});
      continue;
    }
    const int minutes = draw_session(world_.charging, world_.seed, vehicle.id, vehicle.sessions);
    ++vehicle.sessions;
    state_.sessions.push_back({.vehicle = vehicle, .since = minute, .ends = minute + minutes});
  }
}

void RegionPlant::appear(int minute) {
  for (; state_.drawn < size_of(world_.passengers) && world_.passengers[state_.drawn].appears == minute;
       ++state_.drawn) {
    const Passenger& passenger = world_.passengers[state_.drawn];
    RandomStream stream(
        world_.seed, Purpose::extra_passenger,
        {.region = static_cast<std::uint64_t>(world_.region), .index = static_cast<std::uint64_t>(passenger.index)});
    RandomStream turns(
        world_.seed, Purpose::shifted_passenger,
        {.region = static_cast<std::uint64_t>(world_.region), .index = static_cast<std::uint64_t>(passenger.index)});
    const int count = copies(stream.uniform());
    for (int i = 0; i < count; ++i) {
      state_.waiting.push_back(redirected(passenger, turns));
      if (i > 0) {
        state_.waiting.back().patience = draw_patience(world_.patience, stream.uniform());
      }
    }
    said_.demand += count;
    state_.demand += count;
  }
  add_passengers(minute);
}

int RegionPlant::copies(double uniform) {
  double factor = 1.0;
  int count = 1;
  for (std::size_t i = 0; i < incoming_.effects.size(); ++i) {
    if (incoming_.effects[i].type == EffectType::demand_scale) {
      factor *= incoming_.effects[i].magnitude;
      const int scaled = static_cast<int>(std::floor(factor + uniform));
      said_.observed[i].amount += scaled - count;
      count = scaled;
    }
  }
  return count;
}

void RegionPlant::add_passengers(int minute) {
  for (std::size_t i = 0; i < incoming_.effects.size(); ++i) {
    const Effect& effect = incoming_.effects[i];
    if (effect.type != EffectType::demand_add) {
      continue;
    }
    RandomStream stream(world_.seed, Purpose::added_passenger,
                        {.region = static_cast<std::uint64_t>(world_.region),
                         .tick = static_cast<std::uint64_t>(minute),
                         .index = static_cast<std::uint64_t>(effect.fault)});
    const int count = static_cast<int>(stream.poisson(effect.magnitude / 60.0));
    for (int added = 0; added < count; ++added) {
      const int destination = world_.passengers.empty()
                                  ? world_.region
                                  : world_.passengers[stream.below(world_.passengers.size())].destination;
      const Passenger passenger{
          .appears = minute, .patience = draw_patience(world_.patience, stream.uniform()), .destination = destination};
      state_.waiting.push_back(redirected(passenger, stream));
    }
    said_.observed[i].amount += count;
    said_.demand += count;
    state_.demand += count;
  }
}

Passenger RegionPlant::redirected(Passenger passenger, RandomStream& stream) {
  for (std::size_t i = 0; i < incoming_.effects.size(); ++i) {
    const Effect& effect = incoming_.effects[i];
    if (effect.type == EffectType::demand_shift && stream.uniform() < effect.magnitude &&
        passenger.destination != effect.to) {
      passenger.destination = effect.to;
      said_.observed[i].amount += 1.0;
    }
  }
  return passenger;
}

void RegionPlant::serve_or_lose(int minute) {
  std::vector<Passenger> still_waiting;
  for (const auto& passenger : state_.waiting) {
    if (try_serve(passenger, minute)) {
      continue;
    }
    const int waited = minute - passenger.appears;
    if (waited < passenger.patience) {
      still_waiting.push_back(passenger);
    } else {
      said_.fates.push_back(
          {.appeared = passenger.appears, .destination = passenger.destination, .waited = waited, .served = false});
    }
  }
  state_.waiting = std::move(still_waiting);
}

bool RegionPlant::try_serve(const Passenger& passenger, int minute) {
  if (incoming_.unattended) {
    return false;
  }
  const double needed = need_kwh_[passenger.destination] * factor(EffectType::fleet_drain, true);
  const auto car = std::lower_bound(state_.vacant.begin(), state_.vacant.end(), needed,
                                    [](const Vehicle& vehicle, double need) { return vehicle.battery_kwh < need; });
  if (car == state_.vacant.end()) {
    return false;
  }
  said_.fates.push_back({.appeared = passenger.appears,
                         .destination = passenger.destination,
                         .waited = minute - passenger.appears,
                         .served = true,
                         .vehicle = car->id});
  depart(*car, passenger.destination, Errand::passenger, minute);
  state_.vacant.erase(car);
  return true;
}

void RegionPlant::charge() {
  const double capacity = world_.fleet.battery_kwh;
  const double per_minute = world_.charging.power_kw / 60.0;
  const double derated = per_minute * factor(EffectType::charger_derate, false);
  for (auto& session : state_.sessions) {
    if (!session.started) {
      continue;
    }
    const double room = capacity - session.vehicle.battery_kwh;
    const double gain = std::min(derated, room);
    observe(EffectType::charger_derate, std::min(per_minute, room) - gain);
    session.vehicle.battery_kwh += gain;
    said_.charged_kwh += gain;
  }
  said_.queue_minutes += world_.points > 0 ? size_of(state_.queue) : 0;
}

void RegionPlant::settle(Vehicle vehicle) {
  if (vehicle.battery_kwh < reserve_kwh_) {
    state_.queue.push_back(vehicle);
  } else {
    state_.vacant.insert(std::upper_bound(state_.vacant.begin(), state_.vacant.end(), vehicle, less_charge), vehicle);
  }
}

}  // namespace evbal

#include "agents/region/region_plant.hpp"

#include "agents/region/size_of.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

constexpr double passengers_within_reserve = 0.95;
constexpr double largest_reserve = 0.5;  // of the battery: a charged car must not be low again at once

/// The energy that is enough for all but the farthest of `passengers`; without any, for a trip within the region.
double reserve(const std::vector<Passenger>& passengers, const std::vector<double>& need_kwh, int region) {
  if (passengers.empty()) {
    return need_kwh[region];
  }
  std::vector<double> needs;
  needs.reserve(passengers.size());
  for (const auto& passenger : passengers) {
    needs.push_back(need_kwh[passenger.destination]);
  }
  std::sort(needs.begin(), needs.end());
  const double rank = std::ceil(passengers_within_reserve * static_cast<double>(needs.size()));
  return needs[static_cast<std::size_t>(rank) - 1];
}

}  // namespace

RegionPlant::RegionPlant(RegionWorld world) : world_(std::move(world)) {
  const FleetAssumption& fleet = world_.fleet;
  for (std::size_t to = 0; to < world_.km.size(); ++to) {
    trip_kwh_.push_back(world_.km[to] / fleet.km_per_kwh);
    need_kwh_.push_back((world_.km[to] + world_.km_to_station[to]) / fleet.km_per_kwh);
    trip_minutes_.push_back(std::max(1, static_cast<int>(std::ceil(world_.minutes[to]))));
  }
  reserve_kwh_ = std::min(reserve(world_.passengers, need_kwh_, world_.region), largest_reserve * fleet.battery_kwh);
  for (const auto& vehicle : world_.vehicles) {
    settle(vehicle);
  }
}

void RegionPlant::begin(const Tick& tick) {
  const auto here = [&](const auto& entry) { return entry.region == world_.region; };
  incoming_ = {};
  std::copy_if(tick.arrivals.begin(), tick.arrivals.end(), std::back_inserter(incoming_.arrivals), here);
  std::copy_if(tick.under_way.begin(), tick.under_way.end(), std::back_inserter(incoming_.under_way), here);
  std::copy_if(tick.effects.begin(), tick.effects.end(), std::back_inserter(incoming_.effects),
               [&](const Effect& effect) { return here(effect) && family_of(effect.type) <= FaultFamily::sensor; });
  incoming_.unplanned = std::find(tick.unplanned.begin(), tick.unplanned.end(), world_.region) != tick.unplanned.end();
  incoming_.unattended = tick.unattended;
  said_ = {};
  said_.tick = tick.tick;
  said_.region = world_.region;
  for (const auto& effect : incoming_.effects) {
    said_.observed.push_back({.fault = effect.fault});
  }
  mend();
  break_down();
  fail_points();
}

Report RegionPlant::report() {
  Report report;
  report.tick = said_.tick;
  report.region = world_.region;
  const std::vector<Vehicle> vacant = vacant_as_told();
  const double full = chargeable_below * world_.fleet.battery_kwh;
  report.vacant = size_of(vacant);
  report.chargeable = static_cast<std::int32_t>(
      std::ranges::count_if(vacant, [&](const Vehicle& vehicle) { return vehicle.battery_kwh < full; }));
  report.low_battery = size_of(state_.queue);
  report.plugged = size_of(state_.sessions);
  report.points = std::max(points_left(true) - points_blocked(true), report.plugged);
  report.waiting = size_of(state_.waiting);
  report.demand = std::exchange(state_.demand, 0);
  report.completions = std::exchange(state_.completions, 0);
  for (const auto& session : state_.sessions) {
    report.plugged_since.push_back(session.since);
  }
  report.reach_m = short_reach();
  std::map<std::pair<int, Errand>, int> bound;
  for (const auto& arrival : incoming_.arrivals) {
    ++bound[{arrival.minute, arrival.errand}];
  }
  for (const auto& cars : incoming_.under_way) {
    bound[{cars.minute, cars.errand}] += cars.count;
  }
  for (const auto& [when, count] : bound) {
    report.bound.push_back({.region = world_.region, .minute = when.first, .errand = when.second, .count = count});
  }
  return sensed(report, incoming_.effects, world_.clock.tick, world_.seed, state_.sensors, said_.observed);
}

std::vector<std::int32_t> RegionPlant::short_reach() const {
  const double drain = factor(EffectType::fleet_drain, true);
  const double farthest = *std::ranges::max_element(trip_kwh_) * drain;
  std::vector<std::int32_t> metres;
  for (const auto& vehicle : state_.queue) {
    if (vehicle.battery_kwh < farthest) {
      metres.push_back(static_cast<std::int32_t>(1000.0 * vehicle.battery_kwh * world_.fleet.km_per_kwh / drain));
    }
  }
  std::ranges::sort(metres);
  return metres;
}

Departures RegionPlant::live(const Plan* plan) {
  if (incoming_.unplanned && !incoming_.unattended) {
    send_by_own_rule();
  } else if (plan != nullptr) {
    send_off(*plan);
  }
  const int first = world_.clock.minute_of(said_.tick);
  for (int minute = first; minute < first + world_.clock.tick; ++minute) {
    live_minute(minute);
  }
  close_books();
  return std::exchange(said_, {});
}

std::vector<VehiclePlace> RegionPlant::census() const {
  std::vector<VehiclePlace> places;
  for (const auto& vehicle : state_.vacant) {
    places.push_back({vehicle.id, VehicleState::vacant});
  }
  for (const auto& vehicle : state_.queue) {
    places.push_back({vehicle.id, VehicleState::low_battery});
  }
  for (const auto& session : state_.sessions) {
    places.push_back({session.vehicle.id, VehicleState::plugged});
  }
  for (const auto& broken : state_.broken) {
    places.push_back({broken.vehicle.id, VehicleState::broken});
  }
  std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.vehicle < b.vehicle; });
  return places;
}

void RegionPlant::send_by_own_rule() {
  if (world_.points == 0 && world_.station >= 0) {
    send_low_battery(world_.station, size_of(state_.queue));
  }
}

// The farthest move has the fewest cars to choose from; who tops up must not be sent on.
void RegionPlant::send_off(const Plan& plan) {
  std::vector<Move> moves;
  std::ranges::copy_if(plan.moves, std::back_inserter(moves),
                       [&](const Move& move) { return move.from == world_.region && move.count > 0; });
  std::ranges::stable_sort(moves, std::ranges::greater{}, [&](const Move& move) { return energy_for(move); });
  std::int64_t refused = 0;
  for (const Move& move : moves) {
    refused += move.count - (plan.tick == said_.tick ? send(move) : 0);
  }
  said_.refused = static_cast<std::int32_t>(std::min<std::int64_t>(refused, std::numeric_limits<std::int32_t>::max()));
}

// That a car must have to do what it is told; none to stay.
double RegionPlant::energy_for(const Move& move) const {
  if (move.to < 0 || move.to >= size_of(world_.km) || move.to == world_.region) {
    return 0.0;
  }
  return move.errand == Errand::rebalance ? need_kwh_[move.to] : trip_kwh_[move.to];
}

int RegionPlant::send(const Move& move) {
  if (move.to < 0 || move.to >= size_of(world_.km) || move.errand == Errand::passenger) {
    return 0;
  }
  if (move.errand == Errand::rebalance) {
    return move.to == world_.region ? 0 : send_vacant(move.to, move.count);
  }
  return move.to == world_.region ? top_up(move.count) : send_low_battery(move.to, move.count);
}

int RegionPlant::send_vacant(int to, int count) {
  const double need = need_kwh_[to] * factor(EffectType::fleet_drain, true);
  int sent = 0;
  while (sent < count && !state_.vacant.empty() && state_.vacant.back().battery_kwh >= need) {
    depart(state_.vacant.back(), to, Errand::rebalance, world_.clock.minute_of(said_.tick));
    state_.vacant.pop_back();
    ++sent;
  }
  return sent;
}

int RegionPlant::send_low_battery(int to, int count) {
  const double need = trip_kwh_[to] * factor(EffectType::fleet_drain, true);
  int sent = 0;
  for (int i = size_of(state_.queue) - 1; i >= 0 && sent < count; --i) {
    if (state_.queue[i].battery_kwh >= need) {
      depart(state_.queue[i], to, Errand::charge, world_.clock.minute_of(said_.tick));
      state_.queue.erase(state_.queue.begin() + i);
      ++sent;
    }
  }
  return sent;
}

int RegionPlant::top_up(int count) {
  const double full = chargeable_below * world_.fleet.battery_kwh;
  const int most = world_.charging.top_up && world_.points > 0 ? count : 0;
  int sent = 0;
  while (sent < most && !state_.vacant.empty() && state_.vacant.front().battery_kwh < full) {
    state_.queue.push_back(state_.vacant.front());
    state_.vacant.erase(state_.vacant.begin());
    ++sent;
  }
  said_.topped_up += sent;
  return sent;
}

void RegionPlant::depart(Vehicle vehicle, int to, Errand errand, int minute) {
  const double before = vehicle.battery_kwh;
  const double as_usual = std::max(0.0, before - trip_kwh_[to]);
  vehicle.battery_kwh = std::max(0.0, before - trip_kwh_[to] * factor(EffectType::fleet_drain, false));
  const double slower = trip_minutes_[to] * factor(EffectType::travel_slow, false);
  const int minutes = static_cast<int>(std::ceil(slower));
  observe(EffectType::fleet_drain, as_usual - vehicle.battery_kwh);
  observe(EffectType::travel_slow, minutes - trip_minutes_[to]);
  said_.departures.push_back({.minute = minute,
                              .to = to,
                              .arrival_minute = std::max(minute + minutes, world_.clock.minute_of(said_.tick + 1)),
                              .errand = errand,
                              .vehicle = vehicle,
                              .km = world_.km[to]});
}

void RegionPlant::close_books() {
  count_points();
  std::sort(said_.departures.begin(), said_.departures.end(), [](const Departure& a, const Departure& b) {
    return std::tie(a.minute, a.vehicle.id) < std::tie(b.minute, b.vehicle.id);
  });
  said_.vacant = size_of(state_.vacant);
  said_.low_battery = size_of(state_.queue);
  said_.plugged = size_of(state_.sessions);
  said_.points = working_points(false);
  said_.waiting = size_of(state_.waiting);
  said_.broken = size_of(state_.broken);
}

std::vector<RegionPlant> make_plants(const World& world) {
  std::vector<RegionPlant> plants;
  for (RegionWorld& region : region_worlds(world)) {
    plants.emplace_back(std::move(region));
  }
  return plants;
}

}  // namespace evbal

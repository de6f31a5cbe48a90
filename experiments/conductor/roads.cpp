#include "experiments/conductor/roads.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace evbal {
namespace {

constexpr int on_the_road = -1;

bool earlier(const Arrival& a, const Arrival& b) {
  return std::tie(a.region, a.minute, a.vehicle.id) < std::tie(b.region, b.minute, b.vehicle.id);
}

}  // namespace

Roads::Roads(const std::vector<std::vector<Vehicle>>& fleet) : held_(fleet.size(), 0) {
  std::size_t vehicles = 0;
  for (const auto& list : fleet) {
    vehicles += list.size();
  }
  holder_.assign(vehicles, on_the_road);
  for (std::size_t region = 0; region < fleet.size(); ++region) {
    for (const auto& vehicle : fleet[region]) {
      holder_.at(vehicle.id) = static_cast<int>(region);
      ++held_[region];
    }
  }
}

std::vector<Arrival> Roads::hand_out(int minute, int now, const std::set<int>& closed) {
  std::vector<Arrival> arrivals;
  std::vector<Arrival> others;
  for (const auto& car : on_road_) {
    (car.minute < minute && !closed.contains(car.region) ? arrivals : others).push_back(car);
  }
  on_road_ = std::move(others);
  for (auto& car : arrivals) {
    car.minute = std::max(car.minute, now);
    holder_[car.vehicle.id] = car.region;
    ++held_[car.region];
  }
  std::sort(arrivals.begin(), arrivals.end(), earlier);
  return arrivals;
}

std::vector<UnderWay> Roads::under_way() const {
  std::vector<UnderWay> groups;
  for (const auto& car : on_road_) {
    groups.push_back({.region = car.region, .minute = car.minute, .errand = car.errand, .count = 1});
  }
  const auto place = [](const UnderWay& cars) { return std::tie(cars.region, cars.minute, cars.errand); };
  std::sort(groups.begin(), groups.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
  std::vector<UnderWay> merged;
  for (const auto& cars : groups) {
    if (!merged.empty() && place(merged.back()) == place(cars)) {
      ++merged.back().count;
    } else {
      merged.push_back(cars);
    }
  }
  return merged;
}

void Roads::take(const Departures& departures, int tick_end) {
  const int region = departures.region;
  for (const auto& car : departures.departures) {
    const int id = car.vehicle.id;
    const auto refuse = [&](const std::string& why) {
      return run_failed("tick " + std::to_string(departures.tick) + ", region " + std::to_string(region) +
                        ": vehicle " + std::to_string(id) + " " + why);
    };
    if (id < 0 || id >= static_cast<int>(holder_.size()) || holder_[id] != region) {
      throw refuse("left, but was not there");
    }
    if (car.to < 0 || car.to >= static_cast<int>(held_.size())) {
      throw refuse("left for region " + std::to_string(car.to) + ", which does not exist");
    }
    if (car.arrival_minute < tick_end) {
      throw refuse("arrives before the tick ends");
    }
    holder_[id] = on_the_road;
    --held_[region];
    on_road_.push_back({.region = car.to, .minute = car.arrival_minute, .errand = car.errand, .vehicle = car.vehicle});
  }
  std::sort(on_road_.begin(), on_road_.end(), earlier);
}

std::vector<RoadPlace> Roads::census() const {
  std::vector<RoadPlace> places;
  for (const auto& car : on_road_) {
    places.push_back({.vehicle = car.vehicle.id, .destination = car.region, .errand = car.errand});
  }
  std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.vehicle < b.vehicle; });
  return places;
}

}  // namespace evbal

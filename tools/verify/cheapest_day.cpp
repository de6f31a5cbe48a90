#include "tools/verify/cheapest_day.hpp"

#include "common/random.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace evbal {
namespace {

/// A car: the minute of its arrival, -1 if it has been there since before this minute, and the region.
using Car = std::pair<int, int>;

/// All that the rest of a day depends on.
struct Position {
  std::vector<Car> cars;      ///< sorted
  std::vector<bool> settled;  ///< by passenger: taken

  auto operator<=>(const Position&) const = default;
};

class Search {
 public:
  Search(const BoundDay& day, double price) : day_(day), price_(price) {}

  double from_start() {
    Position start;
    for (int region = 0; region < day_.regions(); ++region) {
      start.cars.insert(start.cars.end(), static_cast<std::size_t>(day_.cars[region]), {-1, region});
    }
    start.settled.assign(day_.passengers.size(), false);
    return live(0, start);
  }

 private:
  /// The least that the day costs from the beginning of a minute on.
  double live(int minute, Position at) {
    if (minute == day_.ticks * day_.tick) {
      return price_ * static_cast<double>(std::count(at.settled.begin(), at.settled.end(), false));
    }
    for (auto& [arrives, region] : at.cars) {
      arrives = arrives < minute ? -1 : arrives;
    }
    std::sort(at.cars.begin(), at.cars.end());
    const auto [known, is_new] = known_.emplace(std::pair(minute, at), 0.0);
    if (is_new) {
      const double cost = minute % day_.tick == 0 ? send(minute, at, 0) : take(minute, at, 0);
      known_.at({minute, at}) = cost;
      return cost;
    }
    return known->second;
  }

  /// Car by car: it stays, or is sent somewhere if it is there.
  double send(int minute, const Position& at, std::size_t car) {
    if (car == at.cars.size()) {
      return take(minute, at, 0);
    }
    double least = send(minute, at, car + 1);
    const auto [arrives, region] = at.cars[car];
    for (int to = 0; arrives < 0 && to < day_.regions(); ++to) {
      if (to != region) {
        Position sent = at;
        sent.cars[car] = {arrival(minute, region, to), to};
        least = std::min(least, day_.km(region, to) + send(minute, sent, car + 1));
      }
    }
    return least;
  }

  /// Passenger by passenger: he waits, or is taken if he and a car are there.
  double take(int minute, const Position& at, std::size_t passenger) {
    if (passenger == day_.passengers.size()) {
      return live(minute + 1, at);
    }
    double least = take(minute, at, passenger + 1);
    const BoundPassenger& one = day_.passengers[passenger];
    const auto car = std::find_if(at.cars.begin(), at.cars.end(),
                                  [&](const Car& any) { return any.first <= minute && any.second == one.origin; });
    if (!at.settled[passenger] && one.appears <= minute && minute <= one.last && car != at.cars.end()) {
      Position taken = at;
      taken.settled[passenger] = true;
      taken.cars[static_cast<std::size_t>(car - at.cars.begin())] = {arrival(minute, one.origin, one.destination),
                                                                     one.destination};
      least = std::min(least, take(minute, taken, passenger + 1));
    }
    return least;
  }

  int arrival(int minute, int from, int to) const {
    return std::max(minute + day_.minutes(from, to), (minute / day_.tick + 1) * day_.tick);
  }

  const BoundDay& day_;
  double price_;
  std::map<std::pair<int, Position>, double> known_;
};

}  // namespace

BoundDay tiny_day(std::uint64_t seed) {
  RandomStream random(seed, Purpose::synthetic_city, {.index = 5U});
  const auto below = [&](int count) { return static_cast<int>(random.below(static_cast<std::uint64_t>(count))); };
  BoundDay day;
  day.tick = std::vector<int>{1, 2, 5, 10}[static_cast<std::size_t>(below(4))];
  day.ticks = 40 / day.tick;
  day.step = day.tick;
  day.km = Eigen::MatrixXd::NullaryExpr(2, 2, [&] { return random.uniform(0.5, 6.0); });
  day.minutes = Eigen::MatrixXi::NullaryExpr(2, 2, [&] { return 1 + below(14); });
  day.cars = {below(2), 1};
  for (int i = 0; i < 3 + below(3); ++i) {
    const int appears = below(35);
    day.passengers.push_back(
        {.origin = below(2), .destination = below(2), .appears = appears, .last = std::min(39, appears + below(8))});
  }
  return day;
}

double cheapest_day(const BoundDay& day, double price) {
  return Search(day, price).from_start();
}

}  // namespace evbal

#include "experiments/bound/time_network.hpp"

#include <algorithm>
#include <map>
#include <ranges>
#include <utility>

namespace evbal {
namespace {

/// Ticks, with nodes in them.
class Grid {
 public:
  Grid(const BoundDay& day, Rounding rounding) : day_(day), up_(rounding == Rounding::up ? day.tick - 1 : 0) {}

  int node(int region, int tick) const { return tick < day_.ticks ? tick * day_.regions() + region : -1; }

  /// The tick from which a car is there that left at a minute; cars are handed over between ticks.
  int arrival(int departure, int minutes) const {
    return std::max(departure / day_.tick + 1, (departure + minutes + up_) / day_.tick);
  }

 private:
  const BoundDay& day_;
  int up_;
};

/// Gives back which nodes a car can be at. A passenger brings it nowhere where it could not have driven empty.
std::vector<bool> add_ways(const BoundDay& day, const Grid& grid, TimeNetwork& network) {
  const int n = day.regions();
  std::vector<bool> reached(network.cars.size());
  std::transform(network.cars.begin(), network.cars.end(), reached.begin(), [](double cars) { return cars > 0.0; });
  for (int tick = 0; tick < day.ticks; ++tick) {
    for (int from = 0; from < n; ++from) {
      for (int to = 0; to < n; ++to) {
        const int there = from == to ? tick + 1 : grid.arrival(tick * day.tick, day.minutes(from, to));
        const double km = from == to ? 0.0 : day.km(from, to);
        if (reached[grid.node(from, tick)] && (from == to || there < day.ticks)) {
          network.ways.push_back({grid.node(from, tick), grid.node(to, there), km});
          if (there < day.ticks) {
            reached[grid.node(to, there)] = true;
          }
        }
      }
    }
  }
  return reached;
}

std::vector<Way> trips_of(const BoundDay& day, const Grid& grid, const BoundPassenger& one) {
  std::vector<Way> trips;
  for (int tick = one.appears / day.tick; tick * day.tick <= one.last; ++tick) {
    const int earliest = std::max(one.appears, tick * day.tick);
    const int there = grid.arrival(earliest, day.minutes(one.origin, one.destination));
    trips.push_back({grid.node(one.origin, tick), grid.node(one.destination, there), 0.0});
  }
  return trips;
}

void add_groups(const BoundDay& day, const Grid& grid, const std::vector<bool>& reached, TimeNetwork& network) {
  const auto touched = [](const std::vector<Way>& trips) {
    std::vector<int> nodes;
    for (const Way& trip : trips) {
      nodes.insert(nodes.end(), {trip.from, trip.to});
    }
    return nodes;
  };
  std::map<std::vector<int>, int> group_of;  // by the nodes that its trips touch
  for (const BoundPassenger& one : day.passengers) {
    std::vector<Way> trips = trips_of(day, grid, one);
    std::erase_if(trips, [&](const Way& trip) { return !reached[trip.from]; });
    const auto [at, is_new] = group_of.emplace(touched(trips), static_cast<int>(network.groups.size()));
    if (is_new) {
      network.groups.push_back({static_cast<int>(network.trips.size()), static_cast<int>(trips.size()), 0.0});
      network.trips.insert(network.trips.end(), trips.begin(), trips.end());
    }
    network.groups[at->second].passengers += 1.0;
  }
}

int reach_of(const TimeNetwork& network) {
  int reach = 0;
  for (const Way& way : network.ways) {
    reach = std::max(reach, way.to - way.from);
  }
  for (const PassengerGroup& group : network.groups) {
    for (int i = group.first; i < group.first + group.trips; ++i) {
      const int last = std::max(network.trips[i].from, network.trips[i].to);
      reach = std::max(reach, last - network.trips[group.first].from);
    }
  }
  return reach;
}

double value_at(const std::vector<double>& values, int node) {
  return node < 0 ? 0.0 : values[node];
}

}  // namespace

TimeNetwork time_network(const BoundDay& day, Rounding rounding) {
  const Grid grid(day, rounding);
  TimeNetwork network;
  network.regions = day.regions();
  network.cars.assign(static_cast<std::size_t>(day.ticks) * day.cars.size(), 0.0);
  std::copy(day.cars.begin(), day.cars.end(), network.cars.begin());
  const std::vector<bool> reached = add_ways(day, grid, network);
  add_groups(day, grid, reached, network);
  network.reach = reach_of(network);
  return network;
}

std::vector<double> consistent_values(const TimeNetwork& network, std::vector<double> guess) {
  for (const auto& way : std::views::reverse(network.ways)) {
    guess[way.from] = std::max(guess[way.from], value_at(guess, way.to) - way.km);
  }
  return guess;
}

double lagrangian_bound(const TimeNetwork& network, double price, const std::vector<double>& values) {
  double bound = 0.0;
  for (int node = 0; node < network.nodes(); ++node) {
    bound -= network.cars[node] * values[node];
  }
  for (const PassengerGroup& group : network.groups) {
    double least = price;
    for (int i = group.first; i < group.first + group.trips; ++i) {
      least = std::min(least, values[network.trips[i].from] - value_at(values, network.trips[i].to));
    }
    bound += group.passengers * least;
  }
  return bound;
}

}  // namespace evbal

#include "experiments/bound/starting_point.hpp"

#include <algorithm>

namespace evbal {
namespace {

constexpr double value_of_tick = 0.1;  // km that a car is worth for each tick that is left of the day

/// A passenger's price is half of what he could cost at least, so that something is left on each of his columns.
NetworkRows starting_prices(const TimeNetwork& network, double price) {
  const auto value = [&](int node) {
    const int ticks_left = (network.nodes() - 1 - node) / network.regions + 1;
    return node < 0 ? 0.0 : value_of_tick * ticks_left;
  };
  NetworkRows y{Eigen::VectorXd(network.nodes()), Eigen::VectorXd(static_cast<Eigen::Index>(network.groups.size()))};
  for (int node = 0; node < network.nodes(); ++node) {
    y.nodes[node] = -value(node);
  }
  for (std::size_t group = 0; group < network.groups.size(); ++group) {
    const PassengerGroup& of = network.groups[group];
    double least = price;
    for (int i = of.first; i < of.first + of.trips; ++i) {
      least = std::min(least, value(network.trips[i].from) - value(network.trips[i].to));
    }
    y.groups[static_cast<Eigen::Index>(group)] = 0.5 * least;
  }
  return y;
}

/// Cars on their way through the network, node by node in the order of time.
class Spreading {
 public:
  Spreading(const TimeNetwork& network, const Eigen::VectorXd& z)
      : network_(network), z_(z), here_(network.cars), trips_(network.cars.size()) {
    for (std::size_t group = 0; group < network.groups.size(); ++group) {
      const PassengerGroup& of = network.groups[group];
      for (int i = of.first; i < of.first + of.trips; ++i) {
        // Half of the passengers at most are served, and some are lost.
        trips_[network.trips[i].from].push_back({i, 0.5 * of.passengers / of.trips});
      }
    }
  }

  /// The flow by column, but for those who are lost.
  Eigen::VectorXd flow() {
    const auto ways = static_cast<int>(network_.ways.size());
    Eigen::VectorXd x(ways + static_cast<int>(network_.trips.size()));
    for (int first = 0; first < ways;) {
      const int node = network_.ways[first].from;
      int end = first;
      double shares_of_ways = 0.0;
      for (; end < ways && network_.ways[end].from == node; ++end) {
        shares_of_ways += 1.0 / z_[end];
      }
      double shares = shares_of_ways;
      for (const auto& [trip, most] : trips_[node]) {
        shares += 1.0 / z_[ways + trip];
      }
      const double cars = here_[node];
      for (const auto& [trip, most] : trips_[node]) {
        x[ways + trip] = send(network_.trips[trip], std::min(most, cars / (z_[ways + trip] * shares)));
      }
      const double rest = here_[node];
      for (; first < end; ++first) {
        x[first] = send(network_.ways[first], rest / (z_[first] * shares_of_ways));
      }
    }
    return x;
  }

 private:
  struct Trip {
    int index;
    double most;  ///< passengers
  };

  double send(const Way& way, double cars) {
    here_[way.from] -= cars;
    if (way.to >= 0) {
      here_[way.to] += cars;
    }
    return cars;
  }

  const TimeNetwork& network_;
  const Eigen::VectorXd& z_;
  std::vector<double> here_;              ///< cars, by node
  std::vector<std::vector<Trip>> trips_;  ///< by node
};

}  // namespace

InnerPoint starting_point(const TimeNetwork& network, const Eigen::VectorXd& cost) {
  InnerPoint point;
  const auto groups = static_cast<Eigen::Index>(network.groups.size());
  point.y = starting_prices(network, groups == 0 ? 0.0 : cost[cost.size() - 1]);
  point.z = cost - transposed(columns_of(network), point.y);
  const Eigen::VectorXd flow = Spreading(network, point.z).flow();
  point.x.resize(cost.size());
  point.x.head(flow.size()) = flow;
  for (Eigen::Index group = 0; group < groups; ++group) {
    const PassengerGroup& of = network.groups[static_cast<std::size_t>(group)];
    const auto first = static_cast<Eigen::Index>(network.ways.size()) + of.first;
    point.x[flow.size() + group] = of.passengers - flow.segment(first, of.trips).sum();
  }
  return point;
}

Eigen::VectorXd transposed(const std::vector<NetworkColumn>& columns, const NetworkRows& y) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto& [from, to, group] = columns[i];
    values[static_cast<Eigen::Index>(i)] =
        (from < 0 ? 0.0 : y.nodes[from]) - (to < 0 ? 0.0 : y.nodes[to]) + (group < 0 ? 0.0 : y.groups[group]);
  }
  return values;
}

}  // namespace evbal

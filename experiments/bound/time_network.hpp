#pragma once

#include "experiments/bound/bound_day.hpp"

#include <vector>

namespace evbal {

/// How a minute of arrival becomes a tick.
enum class Rounding {
  down,  ///< a car may serve in the whole tick in which it arrives: it can do no less than a real one
  up,    ///< a car may serve from the first tick that begins when it is there
};

/// What a car can do from one node to a later one.
struct Way {
  int from = 0;     ///< node
  int to = -1;      ///< node, -1 if the car is not back before the day's end
  double km = 0.0;  ///< without a passenger
};

/// Passengers who are alike: of one region to another, in the same ticks.
struct PassengerGroup {
  int first = 0;            ///< of its trips in `trips`: one for each tick in which one of them may be taken
  int trips = 0;            ///< number
  double passengers = 0.0;  ///< number
};

/// Cars and passengers on nodes (region, tick), of which node tick * regions + region is one.
struct TimeNetwork {
  int regions = 0;                     ///< number
  std::vector<double> cars;            ///< by node: who appear there
  std::vector<Way> ways;               ///< to wait, to drive empty or to end the day; by tick of departure
  std::vector<Way> trips;              ///< with a passenger; by group
  std::vector<PassengerGroup> groups;  ///< every passenger is in one; without trips if no car can come in time
  int reach = 0;                       ///< the largest difference of two nodes that a group's trips or a way touch

  /// Number of nodes.
  int nodes() const { return static_cast<int>(cars.size()); }
};

/// The network of a day, without what begins where no car can be. In each tick a car waits, drives empty from the
/// tick's first minute, or takes one passenger.
TimeNetwork time_network(const BoundDay& day, Rounding rounding);

/// What a car is worth at each node, by `guess` (not negative), raised where a car could wait or drive to more.
/// Then no car is worth less than what it can reach, and lagrangian_bound holds.
std::vector<double> consistent_values(const TimeNetwork& network, std::vector<double> guess);

/// A lower bound of price x lost + km over all that cars can do in the network, from consistent values of a car: each
/// passenger is lost at the price or costs the value that a car loses by serving him, whichever is less; and the cars
/// bring their values with them.
double lagrangian_bound(const TimeNetwork& network, double price, const std::vector<double>& values);

}  // namespace evbal

#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/world/world.hpp"
#include "common/eigen.hpp"
#include "experiments/scenario/scenario.hpp"

#include <functional>
#include <vector>

/// The least that a day must cost, whoever plans it (docs/bound.md): what the passengers of the day, the cars and the
/// travel times leave possible if all is known beforehand.
namespace evbal {

/// A passenger who is lost unless a car of his region takes him.
struct BoundPassenger {
  int origin = 0;       ///< region
  int destination = 0;  ///< region
  int appears = 0;      ///< minute
  int last = 0;         ///< minute in which he can be taken at the latest
};

/// All that a bound knows of a day.
struct BoundDay {
  int ticks = 0;                           ///< of the day
  int tick = 5;                            ///< minutes of each
  int step = 30;                           ///< minutes, a multiple of `tick`
  Eigen::MatrixXd km;                      ///< N x N, from and to
  Eigen::MatrixXi minutes;                 ///< N x N, whole minutes of a trip, at least 1
  std::vector<int> cars;                   ///< by region, at the day's start
  std::vector<BoundPassenger> passengers;  ///< by (minute in which they would be lost, region)

  /// Number of regions.
  int regions() const { return static_cast<int>(cars.size()); }
};

/// The day of a world with these faults, by tick. Its passengers are those whom the plant loses on this day without any
/// car: faults of demand have acted on them, and who still waits at the day's end is not among them. All other faults
/// only take from a fleet what it could do, and are left out.
BoundDay bound_day(const World& world, const std::function<Faults(int tick)>& faults);

/// The day of a scenario, with its schedule of faults.
BoundDay bound_day(const Scenario& scenario);

}  // namespace evbal

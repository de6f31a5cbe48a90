#pragma once

#include "coordinator/balancing/arcs.hpp"
#include "coordinator/balancing/problem.hpp"

#include <vector>

namespace evbal {

/// A bound on what a region sends off: at most `most` vehicles go to these targets together.
struct SendLimit {
  int from = 0;              ///< region
  std::vector<int> targets;  ///< regions
  double most = 0.0;         ///< vehicles
};

/// Low-battery cars of a region whose charge lasts for so many km.
double low_battery_reaching(const FleetState& state, int region, double km);

/// What the charge of low-battery cars leaves of the flows along `arcs` (by from): no more cars go a distance or
/// farther than get so far. Only those that say more than the number of cars and than each other; by from, the farthest
/// first.
std::vector<SendLimit> reach_limits(const FleetState& state, const std::vector<Arc>& arcs);

}  // namespace evbal

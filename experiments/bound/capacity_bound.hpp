#pragma once

#include "experiments/bound/bound_day.hpp"

namespace evbal {

/// Passengers whom the fleet must lose because it has no more minutes, wherever its cars are.
struct CapacityBound {
  int lost = 0;   ///< at least
  int start = 0;  ///< minute at which the window begins that is the tightest
  int end = 0;    ///< minute at which it ends
};

/// In a window of minutes each car has the window's length, and a passenger who is served takes at least the least
/// overlap of his trip with it over the minutes at which it may begin. Those who take least are served first. The
/// largest loss over all windows from one step's start to another's.
CapacityBound capacity_bound(const BoundDay& day);

}  // namespace evbal

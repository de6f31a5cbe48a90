#pragma once

#include "experiments/bound/bound_front.hpp"
#include "experiments/scenario/scenario.hpp"

#include <functional>
#include <vector>

namespace evbal {

/// The bound of a scenario's day, at `prices` at least: as it is kept under runs/bounds, else computed, and then kept
/// there. `stop` is that of day_bound. Throws Error.
DayBound kept_bound(const Scenario& scenario, const std::vector<double>& prices,
                    const std::function<bool(const BoundProgress&)>& stop);

/// The same without what is nearly attainable (BoundPoint::up), which takes half of the time.
DayBound kept_bound_alone(const Scenario& scenario, const std::vector<double>& prices);

}  // namespace evbal

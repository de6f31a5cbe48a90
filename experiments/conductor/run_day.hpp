#pragma once

#include "agents/region/world.hpp"
#include "experiments/conductor/players.hpp"

#include <functional>

namespace evbal {

/// Plays the world's day tick by tick and shows each to `observe` once it has passed its checks: every vehicle is in
/// the one region that was handed it or on the road, plants + roads = fleet, points in use <= working points, nobody is
/// planned to send more vehicles than it reported, if the plan believes its report. Throws Error{run_failed} naming
/// tick and region if one does not hold, and whatever `players` throw.
void run_day(const World& world, Players& players, const std::function<void(const TickRecord&)>& observe);

}  // namespace evbal

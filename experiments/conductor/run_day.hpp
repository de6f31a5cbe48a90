#pragma once

#include "agents/world/world.hpp"
#include "experiments/conductor/players.hpp"

#include <functional>

namespace evbal {

/// Plays the world's day tick by tick and shows each to `observe`, in turn, once all is known of it and it has passed
/// its checks. What faults of processes and of the network do is decided here (attendance.hpp): a region whose agent is
/// away is not waited for, and cars bound for it wait on the road; once its agent is back, at the day's end at the
/// latest, it says what became of it meanwhile. The checks: every vehicle is in
/// the one region that was handed it or on the road, plants + roads = fleet, points in use <= working points, nobody is
/// planned to send more vehicles than it reported, if the plan believes its report. Throws Error{run_failed} naming
/// tick and region if one does not hold, and whatever `players` throw.
void run_day(const World& world, Players& players, const std::function<void(const TickRecord&)>& observe);

}  // namespace evbal

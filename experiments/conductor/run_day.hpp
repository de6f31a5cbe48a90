#pragma once

#include "agents/world/world.hpp"
#include "experiments/conductor/players.hpp"

#include <functional>

namespace evbal {

/// Plays the world's day and shows each tick to `observe`, as a Conductor does. Throws as it does, and
/// Error{run_failed} if interrupted. `before_tick` is called between two ticks, with the number of the next.
void run_day(
    const World& world, Players& players, const std::function<void(const TickRecord&)>& observe,
    const std::function<void(int tick)>& before_tick = [](int) {});

}  // namespace evbal

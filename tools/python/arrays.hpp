#pragma once

#include "agents/protocol/messages.hpp"
#include "tools/python/environment.hpp"

#include <pybind11/numpy.h>

#include <string>
#include <vector>

namespace evbal {

/// The names of what is observed of each region.
std::vector<std::string> observation_names();

/// Minute, since the day's start, of the plan that the day waits for; its length if it is over.
int minute_of(const SteppedDay& day);

/// What the coordinator hears before it plans, as arrays of one number a region, int32, all views of one block; and
/// `minute`, since the day's start.
pybind11::dict observation_of(const SteppedDay& day);

/// What became of the day since the last step, as arrays and numbers (docs/python.md).
pybind11::dict info_of(const Environment& environment);

/// The moves that an action asks for: an array of whole numbers, 2 x N x N, vacant cars first, then low-battery ones;
/// rows are origins. Cars on the diagonal stay, but those of the second that are to top up. Throws Error{bad_input}.
std::vector<Move> moves_of(const pybind11::array& action, const Scenario& scenario);

/// A plan as such an action.
pybind11::array_t<std::int32_t> action_of(const Plan& plan, int regions);

}  // namespace evbal

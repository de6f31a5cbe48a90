#pragma once

#include "agents/protocol/tick_record.hpp"
#include "experiments/record/run_record.hpp"
#include "experiments/scenario/scenario.hpp"

#include <optional>
#include <span>

namespace evbal {

/// Makes the first plans of a day that is over anew, as many as the scenario's cross_check asks for, has `ipopt` solve
/// the same problems too, and compares the objectives. What the day's own engine did not bring to an optimum, as under
/// a fault of the solver, is left out. Nothing if no plan is to be checked, if the scenario's engine is `ipopt` itself,
/// or if its plans are not made by evbal. `ticks` are those of the day, from its first one on.
std::optional<CrossChecked> cross_check(const Scenario& scenario, std::span<const TickRecord> ticks);

}  // namespace evbal

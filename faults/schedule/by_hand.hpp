#pragma once

#include "faults/schedule/schedule.hpp"

/// Faults that are added while a day goes on.
namespace evbal {

/// The schedule with one more fault at its end, which begins at `tick`. `entry` is one of a schedule's `faults` without
/// `start` and `arrivals`; without `name` it gets one, such as "by-hand-1". What it leaves open is drawn from the
/// schedule's seed. Throws Error{bad_input} by the same rules as read_schedules, the guard included, and if the
/// injector is away or late at that tick, so that nobody would begin the fault.
Schedule with_fault_by_hand(Schedule schedule, const YamlValue& entry, const FaultContext& context, int tick);

}  // namespace evbal

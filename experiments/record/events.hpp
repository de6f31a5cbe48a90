#pragma once

#include "agents/protocol/tick_record.hpp"

#include <set>
#include <string>
#include <vector>

namespace evbal {

/// Faults that act in a tick, by position in the schedule.
std::set<int> active_faults(const TickRecord& record);

/// What happened in a tick, for the record and the log: a fault begins or ends, a plan fell back, a report was
/// rejected, and at last what befell processes and the bus. `before` is the tick before it, null for the first;
/// `fault_names` go by position in the schedule.
std::vector<Incident> events_of(const TickRecord& record, const TickRecord* before,
                                const std::vector<std::string>& fault_names);

}  // namespace evbal

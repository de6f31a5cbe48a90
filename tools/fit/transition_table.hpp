#pragma once

#include "agents/world/city.hpp"
#include "coordinator/planning/city_model.hpp"
#include "tools/fit/transition_counts.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// Writes the shares of `counts` (periods_of), a row for each: from,region,state,cars,becomes,in_region,share. `from`
/// is when the period begins, states are vacant, occupied and low_battery; `cars` were seen in the region and state.
/// Shares of zero are left out. Returns a report on it, a line an item. Throws Error{run_failed}.
std::string write_transitions(const std::vector<TransitionCounts>& counts, const std::vector<Region>& regions,
                              const std::filesystem::path& file);

/// Reads such a table for a city with the same regions. Throws Error{bad_input} with file and line, also if the shares
/// of a region and state do not sum to one in each period.
std::vector<Period> read_transitions(const std::filesystem::path& file, const std::vector<Region>& regions);

}  // namespace evbal

#pragma once

#include "agents/world/city.hpp"
#include "tools/gps/state_log.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// Writes transitions.csv (ingest_gps) and returns a report on it, a line an item. Rows with few cars are drawn towards
/// the whole day's, with the weight of 50 cars, as in `evbal fit`; shares of zero are left out. Throws
/// Error{run_failed}.
std::string write_transitions(const TransitionCounter& counter, const std::vector<Region>& regions,
                              const std::filesystem::path& file);

}  // namespace evbal

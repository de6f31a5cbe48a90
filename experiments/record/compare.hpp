#pragma once

#include "common/clock.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace evbal {

/// Compares every value of a recorded run with the same run made again: run.sqlite in the order of ticks, steps.csv,
/// regions.csv, summary.json. What depends on how a run was made (processes, seconds) or on its twin is left out. Gives
/// one line that names file, tick (or step) and region of the first difference, nothing if there is none. Files that
/// cannot be read are differences.
std::optional<std::string> first_difference(const std::filesystem::path& recorded,
                                            const std::filesystem::path& replayed, const DayClock& clock);

/// Is scenario.resolved.yaml still the text that the run was made from?
bool scenario_is_original(const std::filesystem::path& folder);

}  // namespace evbal

#pragma once

#include "experiments/record/recorded_run.hpp"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace evbal {

/// The runs as the page reads them. With `map`, region by region too.
nlohmann::ordered_json runs_json(const std::vector<RecordedRun>& runs, bool map);

/// The windows of all runs' faults, each once.
nlohmann::ordered_json windows_json(const std::vector<RecordedRun>& runs);

}  // namespace evbal

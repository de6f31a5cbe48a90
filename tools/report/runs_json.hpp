#pragma once

#include "experiments/bound/bound_front.hpp"
#include "experiments/record/recorded_run.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <vector>

namespace evbal {

/// A run, with what is known of its day beside it.
struct ReportedRun : RecordedRun {
  std::optional<RecordedRun> without_faults{};  ///< the same day, if it was played
  std::optional<DayBound> bound{};              ///< of the day, if it was computed
};

/// The runs as the page reads them. With `map`, region by region too.
nlohmann::ordered_json runs_json(const std::vector<ReportedRun>& runs, bool map);

/// The windows of all runs' faults, each once.
nlohmann::ordered_json windows_json(const std::vector<ReportedRun>& runs);

}  // namespace evbal

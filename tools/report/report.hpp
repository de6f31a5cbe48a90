#pragma once

#include "experiments/record/recorded_run.hpp"
#include "tools/report/forecast_figure.hpp"

#include <string>
#include <vector>

namespace evbal {

/// A self-contained HTML page on one or more runs: totals side by side and, hour by hour, the curves of the paper's
/// figures (idle distance, unfairness of the supply-demand ratio, unfairness of utilisation) beside lost passengers
/// and waits, runs overlaid, fault windows shaded; and what was forecast of the first one's day. Needs no network. The
/// runs must have the same clock: throws Error{bad_input} if not.
std::string report_page(const std::vector<RecordedRun>& runs, const std::vector<ForecastFigure>& forecasts);

}  // namespace evbal

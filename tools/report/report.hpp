#pragma once

#include "experiments/record/recorded_run.hpp"
#include "tools/report/city_map.hpp"
#include "tools/report/forecast_figure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// What a page shows.
struct PageContent {
  std::vector<RecordedRun> runs{};          ///< side by side; of the same clock
  std::vector<ForecastFigure> forecasts{};  ///< of the first run's day
  std::optional<CityMap> map{};             ///< of the runs' city
};

/// A self-contained HTML page, which needs no network (docs/reports.md). Throws Error{bad_input} if the runs have
/// different clocks.
std::string report_page(const PageContent& content);

}  // namespace evbal

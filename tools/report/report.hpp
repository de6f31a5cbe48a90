#pragma once

#include "tools/report/city_map.hpp"
#include "tools/report/forecast_figure.hpp"
#include "tools/report/runs_json.hpp"
#include "tools/report/sweep_json.hpp"

#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// Thresholds of the ambiguity set over a horizon of some steps, as the city's model has them.
struct FittedThresholds {
  std::string series;  ///< "demand"
  int steps = 0;       ///< of the horizon
  double g1 = 0.0;     ///< of the squared Mahalanobis norm
  double g2 = 0.0;     ///< on the second moment
};

/// What a page shows.
struct PageContent {
  std::string title{};                         ///< of the page
  std::string subtitle{};                      ///< below it
  std::vector<ReportedRun> runs{};             ///< side by side; of the same clock
  std::string draws{};                         ///< on draws of the faults of the runs' day, Markdown; may be empty
  std::optional<SweepContent> sweep{};         ///< at least one of it and `runs`
  std::vector<ForecastFigure> forecasts{};     ///< of the first run's day, or of the sweep's first
  std::vector<FittedThresholds> thresholds{};  ///< of the city's model
  std::optional<CityMap> map{};                ///< of the runs' city
  std::vector<std::string> left_out{};         ///< what the page should show and does not, and why: a sentence each
};

/// A self-contained HTML page, which needs no network (docs/reports.md). Throws Error{bad_input} if the runs have
/// different clocks.
std::string report_page(const PageContent& content);

}  // namespace evbal

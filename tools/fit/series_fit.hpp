#pragma once

#include "coordinator/forecast/seasonal_fit.hpp"
#include "coordinator/planning/city_model.hpp"

#include <optional>
#include <vector>

namespace evbal {

/// A series on record.
struct SeriesDays {
  std::vector<CountDay> training;  ///< at least three
  std::vector<CountDay> test;      ///< nothing is fitted to them; may be empty
};

/// Thresholds over the whole horizon for one resample size N_B, and how they hold on the test days.
struct ThresholdRow {
  /// N_B.
  int resample = 0;
  BootstrapThresholds thresholds;  ///< of the training days
  std::optional<Coverage> test;  ///< of the test days; none without any, and for N_B above 100, where it is not defined
};

/// A series' model and how good it is.
struct SeriesFit {
  SeriesModel model;                     ///< forecasts and the laws of their errors
  SeasonalOrders orders;                 ///< that were chosen
  std::vector<HeldOutDay> training;      ///< each day by the model of the others
  std::vector<HeldOutDay> test;          ///< by the model of all training days
  std::vector<ThresholdRow> thresholds;  ///< by N_B; none if no region varies
};

/// Fits forecasts and the distribution of their errors for `leads` steps ahead (docs/model.md, section 5). Only
/// `regions` vary.
SeriesFit fit_series(const SeriesDays& days, int step_minutes, int leads, const std::vector<int>& regions);

/// Squared errors of all of the days, one at least.
Skill skill_of(const std::vector<HeldOutDay>& days);

/// Regions, and the city, that exceed the alarm of `model`'s innovation test, a day; 0 without days.
double alarms_a_day(const SeriesModel& model, const std::vector<HeldOutDay>& days);

/// Whether a region has too few counts to be forecast by more than its seasonal mean.
bool is_thin(const SeasonalOrders& orders, int region);

}  // namespace evbal

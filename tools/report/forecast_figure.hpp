#pragma once

#include "common/eigen.hpp"
#include "coordinator/forecast/seasonal.hpp"

#include <string>

namespace evbal {

/// What a day brought to the whole city in each step, and what was forecast of it one step before (paper, the figure of
/// ARIMA's prediction against history).
struct ForecastFigure {
  std::string title;          ///< above the figure
  std::string note;           ///< below it
  std::string unit;           ///< of the counts
  int start = 0;              ///< minute after midnight at which the day starts
  int step_minutes = 0;       ///< length of a step
  Eigen::VectorXd observed;   ///< by step
  Eigen::VectorXd forecast;   ///< by step, made one step before
  Eigen::VectorXd deviation;  ///< standard deviation of the forecast's error, by the model
};

/// Forecasts each step of `counts` (N x steps) from those before it. The day starts `start` minutes after the model's
/// day.
ForecastFigure forecast_figure(const SeasonalModel& model, DayKind kind, int start, const Eigen::MatrixXd& counts);

}  // namespace evbal

#pragma once

#include "coordinator/forecast/seasonal.hpp"

#include <Eigen/Core>

#include <vector>

namespace evbal {

/// What happened on one day.
struct CountDay {
  DayKind kind = DayKind::weekday;
  Eigen::MatrixXd counts;  ///< N x steps
};

/// Fits means and corrections for `leads` steps ahead. Needs at least two days of the same size.
SeasonalModel fit_seasonal(const std::vector<CountDay>& days, int step_minutes, int leads);

/// Sums of squared errors over regions, per lead.
struct Skill {
  Eigen::VectorXd forecast;
  Eigen::VectorXd seasonal_mean;
  Eigen::VectorXd last_value;

  Skill& operator+=(const Skill& other);
};

/// Forecasts of one day that the model has not seen, made at every step whose horizon ends within the day.
struct HeldOutDay {
  /// Errors divided by Forecaster::scale, one column an origin, stacked step-major (entry (lead, region) at
  /// lead * N + region).
  Eigen::MatrixXd residuals;
  Skill skill;
};
HeldOutDay hold_out(const SeasonalModel& model, const CountDay& day);

/// hold_out of each day with the model fitted to all others; needs at least three days.
std::vector<HeldOutDay> leave_one_day_out(const std::vector<CountDay>& days, int step_minutes, int leads);

}  // namespace evbal

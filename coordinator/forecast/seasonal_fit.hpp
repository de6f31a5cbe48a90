#pragma once

#include "common/eigen.hpp"
#include "coordinator/forecast/seasonal.hpp"

#include <vector>

namespace evbal {

/// What happened on one day.
struct CountDay {
  DayKind kind = DayKind::weekday;  ///< weekday, Saturday, or Sunday and holiday
  Eigen::MatrixXd counts;           ///< N x steps
};

/// Orders of a SeasonalModel's autoregressive moving averages.
struct SeasonalOrders {
  ArmaOrder city;                 ///< of the city's total
  std::vector<ArmaOrder> region;  ///< N
  std::vector<int> thin;          ///< regions with too few counts for any: the seasonal mean is their forecast
};

/// Orders of least AICc among p <= 2, q <= 1; `days` are at least two of the same size.
SeasonalOrders choose_orders(const std::vector<CountDay>& days);

/// Fits means and the coefficients of these orders. Needs at least two days of the same size.
SeasonalModel fit_seasonal(const std::vector<CountDay>& days, int step_minutes, const SeasonalOrders& orders);

/// Squared errors, summed over origins: N x leads.
struct Skill {
  Eigen::MatrixXd forecast;       ///< sum of squared errors, by region and step ahead
  Eigen::MatrixXd seasonal_mean;  ///< of the plain mean over days of the kind, shrunk as the model's but not smoothed
  Eigen::MatrixXd last_value;     ///< the same of the last count

  /// Adds another day's.
  Skill& operator+=(const Skill& other);
};

/// Forecasts of one day that the model has not seen, made at every step whose horizon ends within the day.
struct HeldOutDay {
  /// One column an origin, stacked step-major (entry (lead, region) at lead * N + region).
  Eigen::MatrixXd forecasts;
  Eigen::MatrixXd counts;                 ///< that came
  Eigen::MatrixXd residuals;              ///< errors divided by Forecaster::scale
  Eigen::VectorXd normalised_innovation;  ///< the day's largest of each region and, last, of the city: N + 1
  Skill skill;                            ///< of the day
};

/// Mean counts per region and step of each kind of day, N x steps.
using SeasonalMeans = std::array<Eigen::MatrixXd, day_kinds>;

/// Plain means, thin kinds of day shrunk towards all days: the rival of a forecast. At least one day.
SeasonalMeans seasonal_means(const std::vector<CountDay>& days);

/// Forecasts a day step by step, `leads` steps ahead, against the seasonal mean `rival`.
HeldOutDay hold_out(const SeasonalModel& model, const SeasonalMeans& rival, const CountDay& day, int leads);

/// The alarm of the innovation test: the normalised innovation that the city and its regions, all together, exceed once
/// a day on average over `days`.
double daily_alarm(const std::vector<HeldOutDay>& days);

/// hold_out of each day with the model fitted to all others; needs at least three days.
std::vector<HeldOutDay> leave_one_day_out(const std::vector<CountDay>& days, int step_minutes,
                                          const SeasonalOrders& orders, int leads);

}  // namespace evbal

#include "tools/fit/series_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace evbal {
namespace {

constexpr std::array<int, 6> resample_sizes{10, 20, 50, 100, 500, 1000};
constexpr int most_covered = 100;  ///< N_B up to which held-out coverage is defined

/// Written numbers stay short: a millionth of a vehicle is nothing.
double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

void round(Eigen::Ref<Eigen::MatrixXd> matrix) {
  matrix = matrix.unaryExpr([](double value) { return rounded(value); }).eval();
}

void round(ArmaModel& arma) {
  round(arma.ar);
  round(arma.ma);
  arma.variance = rounded(arma.variance);
}

void round(SeriesModel& model) {
  for (Eigen::MatrixXd& mean : model.seasonal.mean) {
    round(mean);
  }
  round(model.seasonal.city);
  for (ArmaModel& region : model.seasonal.region) {
    round(region);
  }
  round(model.errors.covariance.deviation);
  round(model.errors.covariance.factors);
  model.errors.alarm = rounded(model.errors.alarm);
}

Eigen::MatrixXd residuals_of(const std::vector<HeldOutDay>& days) {
  const Eigen::MatrixXd& first = days.at(0).residuals;
  Eigen::MatrixXd out(first.rows(), first.cols() * static_cast<Eigen::Index>(days.size()));
  for (std::size_t d = 0; d < days.size(); ++d) {
    out.middleCols(first.cols() * static_cast<Eigen::Index>(d), first.cols()) = days[d].residuals;
  }
  return out;
}

Eigen::MatrixXd rows_of(const Eigen::MatrixXd& stacked, int leads, const std::vector<int>& regions) {
  std::vector<Eigen::Index> rows;
  for (int lead = 0; lead < leads; ++lead) {
    for (const int region : regions) {
      rows.push_back(lead * (stacked.rows() / leads) + region);
    }
  }
  return stacked(rows, Eigen::all);
}

std::vector<ThresholdRow> threshold_table(const SeriesFit& fit, int leads, const std::vector<int>& regions) {
  const Covariance& full = fit.model.errors.covariance;
  const Covariance covariance{rows_of(full.deviation, leads, regions), rows_of(full.factors, leads, regions)};
  const Eigen::MatrixXd training = rows_of(residuals_of(fit.training), leads, regions);
  std::vector<ThresholdRow> rows;
  for (const int resample : resample_sizes) {
    const Bootstrap bootstrap{.resample = resample};
    ThresholdRow row{resample, bootstrap_thresholds(training, covariance, bootstrap), {}};
    if (resample <= most_covered && !fit.test.empty()) {
      const Eigen::MatrixXd test = rows_of(residuals_of(fit.test), leads, regions);
      row.test = coverage(test, covariance, row.thresholds.value, bootstrap);
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

SeriesFit fit_series(const SeriesDays& days, int step_minutes, int leads, const std::vector<int>& regions) {
  SeriesFit fit;
  fit.orders = choose_orders(days.training);
  fit.training = leave_one_day_out(days.training, step_minutes, fit.orders, leads);
  fit.model.seasonal = fit_seasonal(days.training, step_minutes, fit.orders);
  fit.model.errors = fit_residual_distribution(residuals_of(fit.training), leads, regions, {});
  fit.model.errors.alarm = daily_alarm(fit.training);
  round(fit.model);
  const SeasonalMeans rival = seasonal_means(days.training);
  for (const CountDay& day : days.test) {
    fit.test.push_back(hold_out(fit.model.seasonal, rival, day, leads));
  }
  if (!regions.empty()) {
    fit.thresholds = threshold_table(fit, leads, regions);
  }
  return fit;
}

Skill skill_of(const std::vector<HeldOutDay>& days) {
  Skill sum = days.at(0).skill;
  for (std::size_t d = 1; d < days.size(); ++d) {
    sum += days[d].skill;
  }
  return sum;
}

double alarms_a_day(const SeriesModel& model, const std::vector<HeldOutDay>& days) {
  const double alarm = model.errors.alarm + 1e-6;  // written numbers are rounded
  Eigen::Index exceeded = 0;
  for (const HeldOutDay& day : days) {
    exceeded += (day.normalised_innovation.array() > alarm).count();
  }
  return static_cast<double>(exceeded) / std::max(1.0, static_cast<double>(days.size()));
}

bool is_thin(const SeasonalOrders& orders, int region) {
  return std::ranges::find(orders.thin, region) != orders.thin.end();
}

}  // namespace evbal

#include "coordinator/forecast/seasonal_fit.hpp"

#include <Eigen/Cholesky>

#include <cassert>
#include <functional>

namespace evbal {
namespace {

constexpr int lags = seasonal_lags;
/// Days of its own kind count once, the mean over all days like so many days more.
constexpr double days_of_pooled_mean = 2.0;

std::vector<CountDay> without(const std::vector<CountDay>& days, std::size_t left_out) {
  std::vector<CountDay> rest = days;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
  return rest;
}

std::array<Eigen::MatrixXd, day_kinds> seasonal_means(const std::vector<CountDay>& days) {
  Eigen::MatrixXd pooled = Eigen::MatrixXd::Zero(days[0].counts.rows(), days[0].counts.cols());
  for (const CountDay& day : days) {
    pooled += day.counts / static_cast<double>(days.size());
  }
  std::array<Eigen::MatrixXd, day_kinds> means;
  for (int kind = 0; kind < day_kinds; ++kind) {
    Eigen::MatrixXd sum = days_of_pooled_mean * pooled;
    double weight = days_of_pooled_mean;
    for (const CountDay& day : days) {
      if (static_cast<int>(day.kind) == kind) {
        sum += day.counts;
        weight += 1.0;
      }
    }
    means[static_cast<std::size_t>(kind)] = sum / weight;
  }
  return means;
}

/// Lives through `day` step by step, calling `look` before each step that can be forecast.
void walk(const SeasonalModel& model, const CountDay& day,
          const std::function<void(int step, const SeasonalForecaster&)>& look) {
  SeasonalForecaster forecaster(model, day.kind);
  const int steps = static_cast<int>(day.counts.cols());
  for (int step = 0; step + model.leads() <= steps; ++step) {
    look(step, forecaster);
    forecaster.observe((step + 1) * model.step_minutes, day.counts.col(step));
  }
}

/// Normal equations of one lead, all regions pooled, errors in units of their scale.
struct LeastSquares {
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(2 * lags, 2 * lags);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * lags);
};

void add_day(std::vector<LeastSquares>& sums, const SeasonalModel& model, const CountDay& day) {
  walk(model, day, [&](int step, const SeasonalForecaster& forecaster) {
    const Deviations deviations = forecaster.deviations();
    for (int lead = 0; lead < model.leads(); ++lead) {
      const int from = (step + lead) * model.step_minutes;
      const Eigen::VectorXd mean = forecaster.seasonal(from, from + model.step_minutes);
      const Eigen::VectorXd weight = count_scale(mean).cwiseInverse();
      const Regressors x = regressors(deviations, mean);
      Eigen::MatrixXd design(mean.size(), 2 * lags);
      design << x.own, x.city;
      design = weight.asDiagonal() * design;
      const Eigen::VectorXd error = (day.counts.col(step + lead) - mean).cwiseProduct(weight);
      LeastSquares& sum = sums[static_cast<std::size_t>(lead)];
      sum.left += design.transpose() * design;
      sum.right += design.transpose() * error;
    }
  });
}

SeasonalModel uncorrected(const std::vector<CountDay>& days, int step_minutes, int leads) {
  return {step_minutes, seasonal_means(days), Eigen::MatrixXd::Zero(lags, leads), Eigen::MatrixXd::Zero(lags, leads)};
}

}  // namespace

SeasonalModel fit_seasonal(const std::vector<CountDay>& days, int step_minutes, int leads) {
  assert(days.size() >= 2);
  // A day's deviations from a mean that contains the day are too small; each is taken from the mean of the others.
  std::vector<LeastSquares> sums(static_cast<std::size_t>(leads));
  for (std::size_t d = 0; d < days.size(); ++d) {
    add_day(sums, uncorrected(without(days, d), step_minutes, leads), days[d]);
  }
  SeasonalModel model = uncorrected(days, step_minutes, leads);
  for (int lead = 0; lead < leads; ++lead) {
    LeastSquares& sum = sums[static_cast<std::size_t>(lead)];
    sum.left.diagonal().array() += 1.0;  // keeps series without counts solvable
    const Eigen::VectorXd coefficients = sum.left.ldlt().solve(sum.right);
    model.own.col(lead) = coefficients.head(lags);
    model.city.col(lead) = coefficients.tail(lags);
  }
  return model;
}

Skill& Skill::operator+=(const Skill& other) {
  forecast += other.forecast;
  seasonal_mean += other.seasonal_mean;
  last_value += other.last_value;
  return *this;
}

HeldOutDay hold_out(const SeasonalModel& model, const CountDay& day) {
  const int n = model.regions();
  const int leads = model.leads();
  const int origins = static_cast<int>(day.counts.cols()) - leads + 1;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(leads);
  HeldOutDay out{Eigen::MatrixXd(n * leads, origins), {zero, zero, zero}};
  walk(model, day, [&](int step, const SeasonalForecaster& forecaster) {
    const int minute = step * model.step_minutes;
    const Eigen::MatrixXd error = day.counts.middleCols(step, leads) - forecaster.forecast(minute, leads);
    out.residuals.col(step) = error.cwiseQuotient(forecaster.scale(minute, leads)).reshaped();
    for (int lead = 0; lead < leads; ++lead) {
      const Eigen::VectorXd truth = day.counts.col(step + lead);
      const int from = minute + lead * model.step_minutes;
      const Eigen::VectorXd mean = forecaster.seasonal(from, from + model.step_minutes);
      const Eigen::VectorXd last = step == 0 ? mean : Eigen::VectorXd(day.counts.col(step - 1));
      out.skill.forecast(lead) += error.col(lead).squaredNorm();
      out.skill.seasonal_mean(lead) += (truth - mean).squaredNorm();
      out.skill.last_value(lead) += (truth - last).squaredNorm();
    }
  });
  return out;
}

std::vector<HeldOutDay> leave_one_day_out(const std::vector<CountDay>& days, int step_minutes, int leads) {
  assert(days.size() >= 3);
  std::vector<HeldOutDay> out;
  out.reserve(days.size());
  for (std::size_t d = 0; d < days.size(); ++d) {
    out.push_back(hold_out(fit_seasonal(without(days, d), step_minutes, leads), days[d]));
  }
  return out;
}

}  // namespace evbal

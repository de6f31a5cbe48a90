#include "coordinator/forecast/seasonal_fit.hpp"

#include "common/contract.hpp"
#include "common/parallel.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace evbal {
namespace {

/// Days of its own kind count once, the mean over all days like so many days more.
constexpr double days_of_pooled_mean = 2.0;
/// Counts on all days together, below which a region's deviations tell nothing.
constexpr double thin = 100.0;

std::vector<CountDay> without(const std::vector<CountDay>& days, std::size_t left_out) {
  std::vector<CountDay> rest = days;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
  return rest;
}

/// Mean over neighbouring steps with binomial weights: a region's day changes slowly, and its counts are few.
Eigen::MatrixXd smoothed(const Eigen::MatrixXd& mean) {
  constexpr std::array<double, 3> weights{6.0, 4.0, 1.0};  // by distance
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(mean.rows(), mean.cols());
  for (int step = 0; step < mean.cols(); ++step) {
    double total = 0.0;
    for (int near = std::max(0, step - 2); near <= std::min(step + 2, static_cast<int>(mean.cols()) - 1); ++near) {
      const double weight = weights[static_cast<std::size_t>(std::abs(near - step))];
      out.col(step) += weight * mean.col(near);
      total += weight;
    }
    out.col(step) /= total;
  }
  return out;
}

SeasonalMeans smoothed_means(const std::vector<CountDay>& days) {
  SeasonalMeans means = seasonal_means(days);
  std::transform(means.begin(), means.end(), means.begin(), smoothed);
  return means;
}

/// C and w of SeasonalModel, a stretch for each day.
struct Series {
  std::vector<Eigen::VectorXd> city;
  std::vector<std::vector<Eigen::VectorXd>> region;
};

/// A day's deviations from a mean that contains the day are too small; each is taken from the mean of the others.
Series deviations(const std::vector<CountDay>& days) {
  Series out;
  out.region.resize(static_cast<std::size_t>(days[0].counts.rows()));
  for (std::size_t d = 0; d < days.size(); ++d) {
    const Eigen::MatrixXd& counts = days[d].counts;
    const Eigen::MatrixXd mean = smoothed_means(without(days, d))[static_cast<std::size_t>(days[d].kind)];
    Eigen::VectorXd city(counts.cols());
    Eigen::MatrixXd region(counts.rows(), counts.cols());
    for (Eigen::Index step = 0; step < counts.cols(); ++step) {
      const Deviation now = deviation(counts.col(step), mean.col(step));
      city(step) = now.city;
      region.col(step) = now.region;
    }
    out.city.push_back(city);
    for (std::size_t i = 0; i < out.region.size(); ++i) {
      out.region[i].emplace_back(region.row(static_cast<Eigen::Index>(i)));
    }
  }
  return out;
}

}  // namespace

SeasonalMeans seasonal_means(const std::vector<CountDay>& days) {
  Eigen::MatrixXd pooled = Eigen::MatrixXd::Zero(days[0].counts.rows(), days[0].counts.cols());
  for (const CountDay& day : days) {
    pooled += day.counts / static_cast<double>(days.size());
  }
  SeasonalMeans means;
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

SeasonalOrders choose_orders(const std::vector<CountDay>& days) {
  EVBAL_EXPECT(days.size() >= 2, "at least two days");
  const std::vector<ArmaOrder> grid{{}, {.p = 1}, {.q = 1}, {.p = 1, .q = 1}, {.p = 2}, {.p = 2, .q = 1}};
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(days[0].counts.rows());
  for (const CountDay& day : days) {
    counts += day.counts.rowwise().sum();
  }
  const Series series = deviations(days);
  SeasonalOrders orders;
  orders.region.resize(series.region.size());
  if (counts.sum() >= thin) {
    orders.city = choose_arma(series.city, grid).model.order();
  }
  parallel_for(series.region.size(), [&](std::size_t i) {
    if (counts(static_cast<Eigen::Index>(i)) >= thin) {
      orders.region[i] = choose_arma(series.region[i], grid).model.order();
    }
  });
  for (int i = 0; i < counts.size(); ++i) {
    if (counts(i) < thin) {
      orders.thin.push_back(i);
    }
  }
  return orders;
}

SeasonalModel fit_seasonal(const std::vector<CountDay>& days, int step_minutes, const SeasonalOrders& orders) {
  EVBAL_EXPECT(days.size() >= 2, "at least two days");
  const Series series = deviations(days);
  SeasonalModel model{step_minutes, smoothed_means(days), fit_arma(series.city, orders.city).model, {}};
  model.region.resize(series.region.size());
  parallel_for(series.region.size(),
               [&](std::size_t i) { model.region[i] = fit_arma(series.region[i], orders.region[i]).model; });
  return model;
}

Skill& Skill::operator+=(const Skill& other) {
  forecast += other.forecast;
  seasonal_mean += other.seasonal_mean;
  last_value += other.last_value;
  return *this;
}

HeldOutDay hold_out(const SeasonalModel& model, const SeasonalMeans& rival, const CountDay& day, int leads) {
  const Eigen::Index n = model.regions();
  const int origins = static_cast<int>(day.counts.cols()) - leads + 1;
  const Eigen::MatrixXd& mean = rival[static_cast<std::size_t>(day.kind)];
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(n, leads);
  const Eigen::MatrixXd columns(n * leads, origins);
  HeldOutDay out{columns, columns, columns, Eigen::VectorXd::Zero(n + 1), {zero, zero, zero}};
  SeasonalForecaster forecaster(model, day.kind);
  for (int step = 0; step < origins; ++step) {
    const int minute = step * model.step_minutes;
    const Eigen::MatrixXd truth = day.counts.middleCols(step, leads);
    const SeasonalForecaster::Prediction ahead = forecaster.predict(minute, leads);
    const Eigen::MatrixXd& forecast = ahead.mean;
    out.normalised_innovation.head(n) = out.normalised_innovation.head(n).cwiseMax(ahead.normalised_innovation.region);
    out.normalised_innovation(n) = std::max(out.normalised_innovation(n), ahead.normalised_innovation.city);
    const Eigen::MatrixXd error = truth - forecast;
    out.forecasts.col(step) = forecast.reshaped();
    out.counts.col(step) = truth.reshaped();
    out.residuals.col(step) = error.cwiseQuotient(forecaster.scale(minute, leads)).reshaped();
    out.skill.forecast += error.cwiseAbs2();
    out.skill.seasonal_mean += (truth - mean.middleCols(step, leads)).cwiseAbs2();
    const Eigen::VectorXd last = step == 0 ? mean.col(0) : day.counts.col(step - 1);
    out.skill.last_value += (truth.colwise() - last).cwiseAbs2();
    forecaster.observe(minute + model.step_minutes, day.counts.col(step));
  }
  return out;
}

double daily_alarm(const std::vector<HeldOutDay>& days) {
  std::vector<double> largest;
  for (const HeldOutDay& day : days) {
    largest.insert(largest.end(), day.normalised_innovation.begin(), day.normalised_innovation.end());
  }
  const auto rank = largest.begin() + static_cast<std::ptrdiff_t>(std::min(days.size(), largest.size() - 1));
  std::nth_element(largest.begin(), rank, largest.end(), std::greater<>());
  return *rank;
}

std::vector<HeldOutDay> leave_one_day_out(const std::vector<CountDay>& days, int step_minutes,
                                          const SeasonalOrders& orders, int leads) {
  EVBAL_EXPECT(days.size() >= 3, "at least three days");
  std::vector<HeldOutDay> out;
  out.reserve(days.size());
  for (std::size_t d = 0; d < days.size(); ++d) {
    const std::vector<CountDay> rest = without(days, d);
    out.push_back(hold_out(fit_seasonal(rest, step_minutes, orders), seasonal_means(rest), days[d], leads));
  }
  return out;
}

}  // namespace evbal

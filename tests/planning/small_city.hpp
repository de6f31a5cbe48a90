#pragma once

#include "agents/world/city.hpp"
#include "coordinator/planning/city_model.hpp"

#include <string>

namespace evbal::testing {

/// A day of the small city.
inline const std::string date = "2008-06-03";

/// Three regions in a row, 5 km apart; points in the first two.
inline City small_city() {
  City city;
  city.name = "small";
  city.day_start = 5 * 60;
  city.regions.resize(3);
  city.fleet.vehicles = 100;
  city.stations = {{"a", 0, 2, {}}, {"b", 1, 1, {}}};
  city.km = (Eigen::MatrixXd(3, 3) << 1, 5, 10, 5, 1, 5, 10, 5, 1).finished();
  city.minutes = 2.0 * city.km;
  return city;
}

inline SeriesModel flat_series(double mean, int leads) {
  SeriesModel series;
  series.seasonal.mean.fill(Eigen::MatrixXd::Constant(3, 38, mean));
  const ArmaModel arma{
      .ar = Eigen::VectorXd::Constant(1, 0.8), .ma = Eigen::VectorXd::Constant(1, -1.0 / 3.0), .variance = 1.0};
  series.seasonal.city = arma;
  series.seasonal.region.assign(3, arma);
  series.errors.covariance.deviation = Eigen::VectorXd::LinSpaced(3 * leads, 0.5, 1.5);
  series.errors.covariance.factors = Eigen::MatrixXd::Constant(3 * leads, 1, 0.3);
  series.errors.thresholds.assign(static_cast<std::size_t>(leads), {0.1, 1.2});
  series.errors.alarm = 2.0;
  return series;
}

/// Vacant cars stay vacant by half, occupied ones become vacant where they go.
inline Transitions simple_transitions() {
  const Eigen::MatrixXd stay = Eigen::MatrixXd::Identity(3, 3);
  const Eigen::MatrixXd spread = Eigen::MatrixXd::Constant(3, 3, 0.4 / 3.0);
  return {0.5 * stay, spread, 0.1 * stay, stay, Eigen::MatrixXd::Zero(3, 3)};
}

inline CityModel small_model(int leads = 2) {
  CityModel model;
  model.city = "small";
  model.day_start = 5 * 60;
  model.holidays = {"2008-05-26"};
  model.demand = flat_series(4.0, leads);
  model.completions = flat_series(1.0, leads);
  model.periods = {{5 * 60, simple_transitions()}, {16 * 60, simple_transitions()}};
  model.trips = {{5 * 60, {{0, 0, 0.5}, {0, 1, 0.5}, {1, 0, 0.25}, {1, 1, 0.5}, {1, 2, 0.25}, {2, 2, 1.0}}},
                 {7 * 60, {{0, 2, 1.0}, {1, 0, 1.0}, {2, 1, 1.0}}}};
  model.turnover = {.demand = {.linear = {1.4}, .quadratic = {0.0}},
                    .phi = 0.5,
                    .same_step_dropoffs = Eigen::MatrixXd::Constant(3, 3, 0.1)};
  model.mean_session_minutes = 45.0;
  return model;
}

}  // namespace evbal::testing

#pragma once

#include "agents/world/city.hpp"
#include "coordinator/planning/city_model.hpp"

namespace evbal {

/// Regions x steps of a day at most: 200 regions take six minutes on a core, and more than an hour if they are 500.
inline constexpr int most_car_values = 8000;

/// What one more vacant car is worth by region and step of a day of this kind, N x steps, in km of empty driving to
/// thousandths: the dual prices of a day planned at once for the demand that `model` expects (docs/fit.md).
/// Deterministic. Throws Error{run_failed} if the linear program has no optimum.
Eigen::MatrixXd car_values(const City& city, const CityModel& model, DayKind kind);

}  // namespace evbal

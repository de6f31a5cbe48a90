#pragma once

#include "agents/city/city.hpp"
#include "coordinator/forecast/seasonal_fit.hpp"
#include "coordinator/planning/city_model.hpp"

#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// Thresholds at horizon's full length for one resample size N_B.
struct ThresholdRow {
  int resample = 0;
  Thresholds demand;
  Thresholds completions;
};

/// A city's model and how good it is.
struct CityFit {
  CityModel model;
  Skill demand;       ///< leave one training day out
  Skill demand_test;  ///< test days, forecast by the model of all training days
  Skill completions;  ///< leave one training day out
  std::vector<ThresholdRow> thresholds;
  int served = 0;  ///< passengers of the training days under `greedy`
  int lost = 0;
};

/// Estimates everything that CityModel holds from the city's training days (model, sections 2 and 5): demand from the
/// records; completions and transitions from the plant, which plays those days under `greedy` without faults.
/// Deterministic. `tell` gets a line on what is done next. Throws Error{bad_input} with fewer than three training days.
CityFit fit_city(const City& city, const std::function<void(const std::string&)>& tell);

}  // namespace evbal

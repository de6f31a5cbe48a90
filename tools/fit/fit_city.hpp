#pragma once

#include "agents/world/city.hpp"
#include "coordinator/planning/city_model.hpp"
#include "tools/fit/series_fit.hpp"

#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// What `turnover` made of some training days with one phi.
struct PhiTrial {
  double phi = 0.0;      ///< that was tried
  int lost = 0;          ///< passengers
  double idle_km = 0.0;  ///< driven
  double cost = 0.0;     ///< idle km, and those that a lost passenger is worth
};

/// A city's model and how good it is.
struct CityFit {
  CityModel model;            ///< what was estimated
  SeriesFit demand;           ///< forecasts of r and their errors
  SeriesFit completions;      ///< forecasts of c and their errors
  std::vector<PhiTrial> phi;  ///< each value that was tried
  int served = 0;             ///< passengers of the training days under `greedy`
  int lost = 0;               ///< likewise
};

/// Estimates everything that CityModel holds from the city's training days, for `leads` steps ahead (docs/model.md,
/// sections 2, 4 and 5): demand from the records; completions and transitions from the plant, which plays those days
/// under `greedy` without faults; phi is the best of several with which `turnover` plays some of them. Test days are
/// forecast, and nothing is fitted to them. `transitions`, if there are any, are taken in place of the plant's, such as
/// those of real drivers (read_transitions). Deterministic. `tell` gets a line on what is done next. Throws
/// Error{bad_input} with fewer than three training days.
CityFit fit_city(const City& city, int leads, const std::function<void(const std::string&)>& tell,
                 const std::vector<Period>& transitions = {});

}  // namespace evbal

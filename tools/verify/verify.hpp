#pragma once

#include "coordinator/planning/city_model.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The largest relative difference that a kind of comparison met.
struct Comparison {
  std::string what;
  int cases = 0;
  double largest = 0.0;  ///< |a - b| / max(1, |b|)
  double allowed = 0.0;
  std::string where = {};  ///< the case with the largest difference

  bool holds() const { return largest <= allowed; }
};

/// Theorem 1's inner problem as printed, by CSDP, against the closed form: random sets, and sets fitted on `model`.
std::vector<Comparison> compare_with_theorem(const CityModel& model);

/// The worst expected shortage in closed form against the moment problem.
Comparison compare_with_moment_problem();

/// Engine against engine, every controller that solves a problem, on random cities.
std::vector<Comparison> compare_engines();

}  // namespace evbal

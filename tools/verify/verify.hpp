#pragma once

#include "coordinator/planning/city_model.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The largest relative difference that a kind of comparison met.
struct Comparison {
  std::string what;        ///< was compared
  int cases = 0;           ///< that were compared
  double largest = 0.0;    ///< |a - b| / max(1, |b|)
  double allowed = 0.0;    ///< greatest difference
  std::string where = {};  ///< the case with the largest difference

  /// Whether the difference is allowed.
  bool holds() const { return largest <= allowed; }
};

/// Theorem 1's inner problem as printed, by CSDP, against the closed form: random sets, and sets fitted on `model`.
std::vector<Comparison> compare_with_theorem(const CityModel& model);

/// The worst expected shortage in closed form against the moment problem.
Comparison compare_with_moment_problem();

/// Engine against engine, every controller that solves a problem, on random cities.
std::vector<Comparison> compare_engines();

/// The bound of tiny days against the cheapest way to play them, of which it may not be above; and its linear program
/// against Clp.
std::vector<Comparison> compare_bounds();

}  // namespace evbal

#pragma once

#include "coordinator/convex/convex_program.hpp"

#include <Eigen/Core>

#include <string>

namespace evbal {

/// How a solve ended and what it is worth. Only `optimal` may be used.
struct Certificate {
  bool optimal = false;
  std::string why_not;  ///< the engine's reason, empty if optimal
  double objective = 0.0;
  double lower_bound = 0.0;  ///< -infinity where the engine gives none
  double gap = 0.0;
  double max_violation = 0.0;  ///< recomputed from the model, not the solver's word
  int iterations = 0;
};

/// Largest constraint violation and relative gap at which a point counts as the optimum.
inline constexpr double optimality_tolerance = 1e-6;

/// What a point of a program is worth, recomputed from the program alone:
/// gap = (objective - lower_bound) / max(1, |objective without penalties|).
/// Not optimal, with the reason, if violation or gap exceeds optimality_tolerance.
Certificate certify(const ConvexProgram& program, const Eigen::VectorXd& x, double lower_bound);

/// A certificate of nothing but a failure.
Certificate refusal(const std::string& why_not);

/// The nearest point within the bounds, its curves' variables lifted onto their curves.
Eigen::VectorXd cleaned(const ConvexProgram& program, Eigen::VectorXd x);

}  // namespace evbal

#pragma once

#include "coordinator/balancing/problem.hpp"
#include "coordinator/balancing/program.hpp"

#include <Eigen/Core>

namespace evbal {

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

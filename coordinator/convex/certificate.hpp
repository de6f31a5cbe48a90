#pragma once

#include "common/eigen.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <string>

namespace evbal {

/// How a solve ended.
enum class SolveStatus {
  optimal,          ///< feasible, and the gap to the lower bound is closed
  refused,          ///< not tried: the data or the program are such that no engine can solve it
  failed,           ///< the engine found no point
  iteration_limit,  ///< the engine spent its iterations before it found a point
  infeasible,       ///< the engine's point violates a constraint
  gap_open,         ///< the engine's point is feasible, but may be worse than the optimum
  below_bound,      ///< the objective is less than its own lower bound, so that one of them is wrong
};

/// How a solve ended and what it is worth. Only an optimal one may be used.
struct Certificate {
  SolveStatus status = SolveStatus::failed;  ///< how the solve ended
  std::string reason;                        ///< why it is not optimal, in words; empty if it is
  double objective = 0.0;                    ///< at the point
  double lower_bound = 0.0;                  ///< -infinity where the engine gives none
  double gap = 0.0;                          ///< (objective - lower_bound) / max(1, |objective - penalty|)
  double max_violation = 0.0;                ///< recomputed from the program, not the solver's word
  int iterations = 0;                        ///< of the engine

  /// Whether the point is a certified optimum.
  bool optimal() const { return status == SolveStatus::optimal; }
};

/// Largest constraint violation and relative gap, either way, at which a point counts as the optimum.
inline constexpr double optimality_tolerance = 1e-6;

/// What a point of a program is worth, recomputed from the program alone: optimal if nothing is violated and the gap is
/// zero, both within optimality_tolerance; else the reason names the row, bound or curve, or the gap.
Certificate certify(const ConvexProgram& program, const Eigen::VectorXd& x, double lower_bound);

/// A certificate of nothing but a failure.
Certificate refusal(const std::string& reason, SolveStatus status = SolveStatus::failed);

/// The nearest point within the bounds, its curves' variables lifted onto their curves.
Eigen::VectorXd cleaned(const ConvexProgram& program, Eigen::VectorXd x);

}  // namespace evbal

#pragma once

#include "coordinator/balancing/program.hpp"

#include <Eigen/Core>

#include <memory>

class ClpSimplex;

namespace evbal {

/// A ConvexProgram with its curves and norms known only through tangents: a linear program (COIN-OR Clp) whose optimum
/// is a lower bound of the program's, since a convex function lies above its tangents.
class LinearRelaxation {
 public:
  /// `program` must outlive this.
  explicit LinearRelaxation(const ConvexProgram& program);
  LinearRelaxation(const LinearRelaxation&) = delete;
  LinearRelaxation& operator=(const LinearRelaxation&) = delete;
  ~LinearRelaxation();

  /// Adds the tangent of every curve and norm at a point of the program.
  void add_tangents(const Eigen::VectorXd& x);

  struct Outcome {
    bool optimal = false;
    double lower_bound = 0.0;  ///< of the program's optimum: safe against the tolerances of the simplex method
    Eigen::VectorXd x;         ///< in the program's variables
    int iterations = 0;        ///< of the simplex method, in all solves
  };

  /// Solves what there is; again after more tangents, from where it stood.
  Outcome solve(int max_iterations);

 private:
  double lower_bound() const;

  const ConvexProgram& program_;
  std::unique_ptr<ClpSimplex> clp_;
};

}  // namespace evbal

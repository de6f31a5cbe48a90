#include "coordinator/convex/cuts_engine.hpp"

#include "coordinator/convex/certificate.hpp"
#include "coordinator/convex/linear_relaxation.hpp"

#include <algorithm>
#include <string>

namespace evbal {
Solution solve_with_cuts(const ConvexProgram& program, const EngineSettings& settings) {
  LinearRelaxation relaxation(program);
  Solution best;
  double objective = ConvexProgram::infinity;
  double lower_bound = -ConvexProgram::infinity;
  for (int iteration = 1; iteration <= settings.max_iterations; ++iteration) {
    const auto outcome = relaxation.solve();
    if (!outcome.optimal) {
      best = {{}, refusal("Clp finds no optimum of linear program " + std::to_string(iteration))};
      best.certificate.iterations = iteration;
      return best;
    }
    const Eigen::VectorXd x = cleaned(program, outcome.x);
    lower_bound = std::max(lower_bound, outcome.lower_bound);
    if (program.objective(x) < objective) {
      objective = program.objective(x);
      best.x = x;
    }
    best.certificate = certify(program, best.x, lower_bound);
    best.certificate.iterations = iteration;
    if (best.certificate.gap <= optimality_tolerance) {
      break;
    }
    relaxation.refine(x);
  }
  return best;
}

}  // namespace evbal

#include "coordinator/convex/cuts_engine.hpp"

#include "coordinator/convex/certificate.hpp"
#include "coordinator/convex/linear_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace evbal {
namespace {

Solution failure(int iteration, const std::string& why_not) {
  Solution failed{{}, refusal("linear program " + std::to_string(iteration) + ": " + why_not)};
  failed.certificate.iterations = iteration;
  return failed;
}

}  // namespace

Solution solve_with_cuts(const ConvexProgram& program, const EngineSettings& settings, const Start& start) {
  LinearRelaxation relaxation(program, start);
  Solution best{{}, refusal("no linear program was allowed", SolveStatus::iteration_limit)};
  double objective = ConvexProgram::infinity;
  double lower_bound = -ConvexProgram::infinity;
  for (int iteration = 1; iteration <= settings.max_iterations; ++iteration) {
    const auto outcome = relaxation.solve();
    if (!outcome.why_not.empty()) {
      return failure(iteration, outcome.why_not);
    }
    const Eigen::VectorXd x = cleaned(program, outcome.x);
    const double value = program.objective(x);
    if (!std::isfinite(value)) {
      return failure(iteration, "the objective is not finite at its optimum");
    }
    lower_bound = std::max(lower_bound, outcome.lower_bound);
    if (value < objective) {
      objective = value;
      best.x = x;
    }
    best.certificate = certify(program, best.x, lower_bound);
    best.certificate.iterations = iteration;
    if (best.certificate.gap <= optimality_tolerance) {
      break;
    }
    relaxation.refine(x);
  }
  best.start = relaxation.start();
  return best;
}

}  // namespace evbal

#include "coordinator/balancing/cuts_engine.hpp"

#include "coordinator/balancing/certificate.hpp"
#include "coordinator/balancing/linear_relaxation.hpp"

#include <algorithm>
#include <string>

namespace evbal {
namespace {

// The first tangents: spread ever wider from the lower ends of the curves, where they bend most. More of them save a
// round and cost as much in every other.
void add_first_tangents(const ConvexProgram& program, LinearRelaxation& relaxation) {
  constexpr int points = 13;
  double offset = 0.0;
  for (int point = 0; point < points; ++point) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(program.variables());
    for (const auto& curve : program.curves()) {
      x(curve.of) = program.lower()[static_cast<std::size_t>(curve.of)] + offset;
    }
    relaxation.add_tangents(cleaned(program, x));
    offset = 1.5 * offset + 0.5;
  }
}

}  // namespace

Solution solve_with_cuts(const ConvexProgram& program, const EngineSettings& settings) {
  constexpr int max_simplex_iterations = 200000;  // of one linear program
  LinearRelaxation relaxation(program);
  add_first_tangents(program, relaxation);
  Solution best;
  double objective = ConvexProgram::infinity;
  double lower_bound = -ConvexProgram::infinity;
  for (int iteration = 1; iteration <= settings.max_iterations; ++iteration) {
    const auto outcome = relaxation.solve(max_simplex_iterations);
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
    relaxation.add_tangents(x);
  }
  return best;
}

}  // namespace evbal

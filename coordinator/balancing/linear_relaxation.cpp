#include "coordinator/balancing/linear_relaxation.hpp"

#include <coin/ClpSimplex.hpp>
#include <coin/CoinPackedMatrix.hpp>

#include <algorithm>
#include <vector>

namespace evbal {
namespace {

// The program's columns, then one column a norm that stands above it.
CoinPackedMatrix matrix_of(const ConvexProgram& program) {
  std::vector<int> columns;
  std::vector<double> elements;
  std::vector<CoinBigIndex> starts(program.row_start().begin(), program.row_start().end());
  for (const auto& [variable, coefficient] : program.entries()) {
    columns.push_back(variable);
    elements.push_back(coefficient);
  }
  CoinPackedMatrix matrix(false, program.variables(), program.rows(), static_cast<CoinBigIndex>(elements.size()),
                          elements.data(), columns.data(), starts.data(), nullptr);
  matrix.setDimensions(program.rows(), program.variables() + static_cast<int>(program.norms().size()));
  return matrix;
}

// Clp knows the largest double as no bound, and no infinity.
std::vector<double> clp_bounds(std::vector<double> bounds) {
  for (double& bound : bounds) {
    bound = std::clamp(bound, -COIN_DBL_MAX, COIN_DBL_MAX);
  }
  return bounds;
}

}  // namespace

LinearRelaxation::LinearRelaxation(const ConvexProgram& program)
    : program_(program), clp_(std::make_unique<ClpSimplex>()) {
  std::vector<double> lower = clp_bounds(program.lower());
  std::vector<double> upper = clp_bounds(program.upper());
  std::vector<double> cost = program.cost();
  for (const auto& norm : program.norms()) {
    lower.push_back(0.0);
    upper.push_back(COIN_DBL_MAX);
    cost.push_back(norm.weight);
  }
  clp_->setLogLevel(0);
  // Shares of a transition go down to nothing, and geometric scaling makes them loud: with it Clp 1.17 stops at points
  // up to 8 % off and calls them optimal, and takes five times as long. Vehicles and km are of one size as they are.
  clp_->scaling(0);
  clp_->loadProblem(matrix_of(program), lower.data(), upper.data(), cost.data(), clp_bounds(program.row_low()).data(),
                    clp_bounds(program.row_high()).data());
}

LinearRelaxation::~LinearRelaxation() = default;

void LinearRelaxation::add_tangents(const Eigen::VectorXd& x) {
  // above >= f(x) + f'(x) (of - x)
  for (const auto& curve : program_.curves()) {
    const auto jet = curve.function->around(x(curve.of));
    const std::vector<int> columns = {curve.above, curve.of};
    const std::vector<double> elements = {1.0, -jet.slope};
    clp_->addRow(2, columns.data(), elements.data(), jet.value - jet.slope * x(curve.of), COIN_DBL_MAX);
  }
  // t >= (Sigma z)' Z / || Sigma^(1/2) z ||
  int t = program_.variables();
  for (const auto& term : program_.norms()) {
    const Eigen::VectorXd z = values_of(term.variables, x);
    const double norm = term.norm(z);
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(z.size());
    if (norm > 0.0) {
      slope = (term.deviation.array().square() * z.array()).matrix() + term.factors * (term.factors.transpose() * z);
      slope /= -norm;
    }
    std::vector<int> columns = term.variables;
    std::vector<double> elements(slope.begin(), slope.end());
    columns.push_back(t++);
    elements.push_back(1.0);
    clp_->addRow(static_cast<int>(columns.size()), columns.data(), elements.data(), 0.0, COIN_DBL_MAX);
  }
}

LinearRelaxation::Outcome LinearRelaxation::solve(int max_iterations) {
  clp_->setMaximumIterations(clp_->numberIterations() + max_iterations);
  clp_->dual();
  return {.optimal = clp_->isProvenOptimal(),
          .objective = clp_->objectiveValue() + program_.constant(),
          .x = Eigen::Map<const Eigen::VectorXd>(clp_->primalColumnSolution(), program_.variables()),
          .iterations = clp_->numberIterations()};
}

}  // namespace evbal

#include "coordinator/balancing/linear_relaxation.hpp"

#include <coin/ClpSimplex.hpp>
#include <coin/CoinPackedMatrix.hpp>

#include <algorithm>
#include <cmath>
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

// New rows  coefficients'x >= low, added in one go.
class Rows {
 public:
  void add(int column, double element) {
    columns_.push_back(column);
    elements_.push_back(element);
  }

  void end(double low) {
    low_.push_back(low);
    starts_.push_back(static_cast<CoinBigIndex>(columns_.size()));
  }

  void add_to(ClpSimplex& clp) const {
    const std::vector<double> high(low_.size(), COIN_DBL_MAX);
    clp.addRows(static_cast<int>(low_.size()), low_.data(), high.data(), starts_.data(), columns_.data(),
                elements_.data());
  }

 private:
  std::vector<double> low_;
  std::vector<CoinBigIndex> starts_ = {0};
  std::vector<int> columns_;
  std::vector<double> elements_;
};

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
  // Where a curve falls by thousands a vehicle, the default of 1e-7 vehicles costs more than a gap of 1e-6 allows.
  clp_->setPrimalTolerance(1e-9);
  clp_->loadProblem(matrix_of(program), lower.data(), upper.data(), cost.data(), clp_bounds(program.row_low()).data(),
                    clp_bounds(program.row_high()).data());
}

LinearRelaxation::~LinearRelaxation() = default;

void LinearRelaxation::add_tangents(const Eigen::VectorXd& x) {
  Rows rows;
  // above >= f(x) + f'(x) (of - x)
  for (const auto& curve : program_.curves()) {
    const auto jet = curve.function->around(x(curve.of));
    rows.add(curve.above, 1.0);
    rows.add(curve.of, -jet.slope);
    rows.end(jet.value - jet.slope * x(curve.of));
  }
  // t >= (Sigma z)' Z / || Sigma^(1/2) z ||
  int t = program_.variables();
  for (const auto& term : program_.norms()) {
    const Eigen::VectorXd z = values_of(term.variables, x);
    const double norm = term.norm(z);
    if (norm > 0.0) {
      const Eigen::VectorXd slope =
          ((term.deviation.array().square() * z.array()).matrix() + term.factors * (term.factors.transpose() * z)) /
          norm;
      for (Eigen::Index i = 0; i < z.size(); ++i) {
        rows.add(term.variables[static_cast<std::size_t>(i)], -slope(i));
      }
      rows.add(t, 1.0);
      rows.end(0.0);
    }
    ++t;
  }
  rows.add_to(*clp_);
}

// For any multipliers y of the rows,  cost'x = (cost - A'y)'x + y'(A x)  is at least what bounds and rows allow term by
// term. At the optimum the reduced costs of variables without a bound are zero but for rounding; that rest is charged
// as if those variables reached ten times the largest value of the optimum.
double LinearRelaxation::lower_bound() const {
  const int columns = clp_->numberColumns();
  const int rows = clp_->numberRows();
  const Eigen::Map<const Eigen::VectorXd> x(clp_->primalColumnSolution(), columns);
  const double reach = 10.0 * std::max(1.0, x.cwiseAbs().maxCoeff());
  const auto least = [reach](double price, double low, double high) {
    return price * (price > 0.0 ? std::max(low, -reach) : std::min(high, reach));
  };
  double bound = program_.constant();
  Eigen::VectorXd multiplier(rows);
  for (int row = 0; row < rows; ++row) {
    const double y = clp_->dualRowSolution()[row];
    const double side = y > 0.0 ? clp_->rowLower()[row] : clp_->rowUpper()[row];
    multiplier(row) = std::abs(side) < COIN_DBL_MAX ? y : 0.0;
    bound += multiplier(row) == 0.0 ? 0.0 : y * side;
  }
  Eigen::VectorXd priced(columns);
  clp_->matrix()->transposeTimes(multiplier.data(), priced.data());
  for (int i = 0; i < columns; ++i) {
    bound += least(clp_->objective()[i] - priced(i), clp_->columnLower()[i], clp_->columnUpper()[i]);
  }
  return bound;
}

LinearRelaxation::Outcome LinearRelaxation::solve(int max_iterations) {
  clp_->setMaximumIterations(clp_->numberIterations() + max_iterations);
  clp_->dual();
  return {.optimal = clp_->isProvenOptimal(),
          .lower_bound = lower_bound(),
          .x = Eigen::Map<const Eigen::VectorXd>(clp_->primalColumnSolution(), program_.variables()),
          .iterations = clp_->numberIterations()};
}

}  // namespace evbal

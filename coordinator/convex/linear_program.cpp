#include "coordinator/convex/linear_program.hpp"

#include <coin/ClpSimplex.hpp>
#include <coin/CoinPackedMatrix.hpp>

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

// Clp knows the largest double as no bound, and no infinity.
std::vector<double> clp_bounds(std::vector<double> bounds) {
  for (double& bound : bounds) {
    bound = std::clamp(bound, -COIN_DBL_MAX, COIN_DBL_MAX);
  }
  return bounds;
}

}  // namespace

LinearProgram::LinearProgram(const ConvexProgram& program)
    : constant_(program.constant()), lower_(program.lower()), upper_(program.upper()), cost_(program.cost()) {}

int LinearProgram::add_column(double lower, double upper, double cost) {
  lower_.push_back(lower);
  upper_.push_back(upper);
  cost_.push_back(cost);
  return columns() - 1;
}

void LinearProgram::bound(int column, double lower, double upper) {
  lower_[static_cast<std::size_t>(column)] = lower;
  upper_[static_cast<std::size_t>(column)] = upper;
}

void LinearProgram::add(int column, double coefficient) {
  entry_column_.push_back(column);
  entry_.push_back(coefficient);
}

void LinearProgram::end_row(double low, double high) {
  row_low_.push_back(low);
  row_high_.push_back(high);
  row_start_.push_back(static_cast<int>(entry_.size()));
}

std::shared_ptr<ClpSimplex> LinearProgram::load() const {
  CoinPackedMatrix matrix(false, columns(), rows(), static_cast<CoinBigIndex>(entry_.size()), entry_.data(),
                          entry_column_.data(), row_start_.data(), nullptr);
  matrix.setDimensions(rows(), columns());
  auto clp = std::make_shared<ClpSimplex>();
  clp->setLogLevel(0);
  // Shares of a transition go down to nothing, and geometric scaling makes them loud: with it Clp 1.17 stops at points
  // up to 8 % off and calls them optimal, and takes five times as long. Vehicles and km are of one size as they are.
  clp->scaling(0);
  // Where a curve falls by thousands a vehicle, the default of 1e-7 vehicles costs more than a gap of 1e-6 allows.
  clp->setPrimalTolerance(1e-9);
  clp->setMaximumIterations(max_simplex_iterations);
  clp->loadProblem(matrix, clp_bounds(lower_).data(), clp_bounds(upper_).data(), cost_.data(),
                   clp_bounds(row_low_).data(), clp_bounds(row_high_).data());
  return clp;
}

// For any multipliers y of the rows,  cost'x = (cost - A'y)'x + y'(A x)  is at least what bounds and rows allow term by
// term. At the optimum the reduced costs of variables without a bound are zero but for rounding; that rest is charged
// as if those variables reached ten times the largest value of the optimum.
double LinearProgram::lower_bound(const ClpSimplex& solved) const {
  const Eigen::Map<const Eigen::VectorXd> x(solved.primalColumnSolution(), columns());
  const double reach = 10.0 * std::max(1.0, x.cwiseAbs().maxCoeff());
  const auto least = [reach](double price, double low, double high) {
    return price * (price > 0.0 ? std::max(low, -reach) : std::min(high, reach));
  };
  double bound = constant_;
  Eigen::VectorXd multiplier(rows());
  for (int row = 0; row < rows(); ++row) {
    const double y = solved.dualRowSolution()[row];
    const double side = y > 0.0 ? solved.rowLower()[row] : solved.rowUpper()[row];
    multiplier(row) = std::abs(side) < COIN_DBL_MAX ? y : 0.0;
    bound += multiplier(row) == 0.0 ? 0.0 : y * side;
  }
  Eigen::VectorXd priced(columns());
  solved.matrix()->transposeTimes(multiplier.data(), priced.data());
  for (int i = 0; i < columns(); ++i) {
    bound += least(solved.objective()[i] - priced(i), solved.columnLower()[i], solved.columnUpper()[i]);
  }
  return bound;
}

}  // namespace evbal

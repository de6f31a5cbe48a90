#include "coordinator/convex/linear_program.hpp"

#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>
#include <CoinPackedMatrix.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evbal {
namespace {

// Clp takes the largest double for no bound; it does not know infinity.
std::vector<double> clp_bounds(std::vector<double> bounds) {
  for (double& bound : bounds) {
    bound = std::clamp(bound, -COIN_DBL_MAX, COIN_DBL_MAX);
  }
  return bounds;
}

// A lower bound may be -infinity and an upper one infinity: they bind nothing.
bool is_fit_as_low(double bound) {
  return bound == -ConvexProgram::infinity || is_fit(bound);
}

bool is_fit_as_high(double bound) {
  return bound == ConvexProgram::infinity || is_fit(bound);
}

std::string out_of_range(const std::string& what, double number) {
  std::ostringstream out;
  out << what << ": " << number << " is not in [" << -largest_number << ", " << largest_number << ']';
  return out.str();
}

// Names the first of `numbers` that is not fit, empty if all are.
template <class IsFit>
std::string first_unfit(const std::vector<double>& numbers, const std::string& what, const LinearProgram::Names& name,
                        const IsFit& is_fit_there) {
  const auto wrong = std::ranges::find_if_not(numbers, is_fit_there);
  return wrong == numbers.end() ? "" : out_of_range(what + name(static_cast<int>(wrong - numbers.begin())), *wrong);
}

}  // namespace

bool is_fit(double number) {
  return std::abs(number) <= largest_number;
}

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

std::string LinearProgram::unfit(const Names& column, const Names& row) const {
  if (!is_fit(constant_)) {
    return out_of_range("constant", constant_);
  }
  const auto entry = std::ranges::find_if_not(entry_, is_fit);
  if (entry != entry_.end()) {
    return out_of_range("coefficient of " + column(entry_column_[static_cast<std::size_t>(entry - entry_.begin())]),
                        *entry);
  }
  for (const std::string& why_not :
       {first_unfit(cost_, "cost of ", column, is_fit), first_unfit(lower_, "lower bound of ", column, is_fit_as_low),
        first_unfit(upper_, "upper bound of ", column, is_fit_as_high),
        first_unfit(row_low_, "lower side of ", row, is_fit_as_low),
        first_unfit(row_high_, "upper side of ", row, is_fit_as_high)}) {
    if (!why_not.empty()) {
      return why_not;
    }
  }
  return "";
}

std::string LinearProgram::unfit() const {
  return unfit([](int column) { return "variable " + std::to_string(column); },
               [](int row) { return "row " + std::to_string(row); });
}

std::shared_ptr<ClpSimplex> LinearProgram::load() const {
  CoinPackedMatrix matrix(false, columns(), rows(), static_cast<CoinBigIndex>(entry_.size()), entry_.data(),
                          entry_column_.data(), row_start_.data(), nullptr);
  matrix.setDimensions(rows(), columns());
  auto clp = std::make_shared<ClpSimplex>();
  clp->setLogLevel(0);
  // Without scaling: shares of a transition may be tiny, and geometric scaling would magnify them. With it Clp 1.17
  // calls points optimal that are up to 8 % off, and takes five times as long.
  clp->scaling(0);
  // Where a curve falls by thousands a vehicle, the default of 1e-7 vehicles costs more than a gap of 1e-6 allows.
  clp->setPrimalTolerance(1e-9);
  clp->setMaximumIterations(max_simplex_iterations);
  clp->loadProblem(matrix, clp_bounds(lower_).data(), clp_bounds(upper_).data(), cost_.data(),
                   clp_bounds(row_low_).data(), clp_bounds(row_high_).data());
  return clp;
}

std::optional<Eigen::VectorXd> LinearProgram::multipliers() const {
  const std::shared_ptr<ClpSimplex> clp = load();
  ClpSolve interior;
  interior.setSolveType(ClpSolve::useBarrierNoCross);
  clp->initialSolve(interior);
  return clp->isProvenOptimal()
             ? std::optional<Eigen::VectorXd>(Eigen::Map<const Eigen::VectorXd>(clp->dualRowSolution(), rows()))
             : std::nullopt;
}

// For any multipliers y of the rows,  cost'x = (cost - A'y)'x + y'(A x)  is at least what bounds and rows allow term by
// term. At the optimum the reduced costs of variables without a bound are zero but for rounding; what rounding leaves
// is multiplied by ten times the largest value of the optimum, as if those variables reached that far.
double LinearProgram::lower_bound(const ClpSimplex& solved) const {
  const Eigen::Map<const Eigen::VectorXd> x(solved.primalColumnSolution(), columns());
  const double reach = 10.0 * std::max(1.0, x.lpNorm<Eigen::Infinity>());
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

LinearProgram linear_part(const ConvexProgram& program) {
  LinearProgram lp(program);
  for (std::size_t row = 0; row + 1 < program.row_start().size(); ++row) {
    for (int at = program.row_start()[row]; at < program.row_start()[row + 1]; ++at) {
      const auto& [variable, coefficient] = program.entries()[static_cast<std::size_t>(at)];
      lp.add(variable, coefficient);
    }
    lp.end_row(program.row_low()[row], program.row_high()[row]);
  }
  return lp;
}

}  // namespace evbal

#include "coordinator/convex/linear_relaxation.hpp"

#include "common/contract.hpp"

#include <ClpSimplex.hpp>

#include <algorithm>
#include <span>

namespace evbal {
namespace {

constexpr double infinity = ConvexProgram::infinity;

// A tangent of a norm at x, scaled down until no variable's cost becomes negative, which could make the linear program
// unbounded. A norm lies above a scaled-down tangent too.
Eigen::VectorXd affordable_gradient(const ConvexProgram& program, const NormTerm& norm, const Eigen::VectorXd& x) {
  const Eigen::VectorXd gradient = norm.gradient(values_of(norm.variables, x));
  double share = 1.0;
  for (std::size_t i = 0; i < norm.variables.size(); ++i) {
    const double cost = std::max(0.0, program.cost()[static_cast<std::size_t>(norm.variables[i])]);
    const double change = norm.weight * gradient(static_cast<Eigen::Index>(i));
    share = cost + change < 0.0 ? std::min(share, -cost / change) : share;
  }
  return share * gradient;
}

// Makes a column basic in place of a row.
void make_basic(ClpSimplex& clp, int column, int row) {
  clp.setColumnStatus(column, ClpSimplex::basic);
  clp.setRowStatus(row, ClpSimplex::atUpperBound);
}

// Gives a row the price at which the column of `basic` costs nothing, and takes it from the reduced costs.
void subtract_price(std::vector<double>& reduced, std::span<const Expression::Term> row,
                    const Expression::Term& basic) {
  const double price = reduced[static_cast<std::size_t>(basic.variable)] / basic.coefficient;
  for (const auto& [variable, coefficient] : row) {
    reduced[static_cast<std::size_t>(variable)] -= price * coefficient;
  }
}

}  // namespace

// Columns: the program's, a height for each norm, then each curve's parts. Rows: the program's, one for each curve's
// argument, then the norms' further tangents. So all but the parts keep their place from solve to solve.
LinearRelaxation::LinearRelaxation(const ConvexProgram& program) : program_(program) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(program.variables());
  curve_above_.assign(program.cost().size(), -1);
  has_curve_.assign(program.cost().size(), false);
  for (const auto& curve : program.curves()) {
    int& above = curve_above_[static_cast<std::size_t>(curve.above)];
    EVBAL_EXPECT(above < 0, "a variable above one curve at most");
    above = static_cast<int>(curves_.size());
    has_curve_[static_cast<std::size_t>(curve.of)] = true;
    const double lower = program.lower()[static_cast<std::size_t>(curve.of)];
    const double upper = program.upper()[static_cast<std::size_t>(curve.of)];
    curves_.push_back({&curve, Tangents(curve.function, lower, upper)});
    x(curve.above) = curve.function->around(std::min(lower + 1.0, upper)).value;
  }
  for (const auto& norm : program.norms()) {
    first_gradients_.push_back(affordable_gradient(program, norm, x));
  }
}

LinearProgram LinearRelaxation::linear_program() {
  LinearProgram lp(program_);
  add_columns(lp);
  for (std::size_t row = 0; row + 1 < program_.row_start().size(); ++row) {
    double constant = 0.0;
    for (int at = program_.row_start()[row]; at < program_.row_start()[row + 1]; ++at) {
      const auto& [variable, coefficient] = program_.entries()[static_cast<std::size_t>(at)];
      constant += write(lp, variable, coefficient);
    }
    lp.end_row(program_.row_low()[row] - constant, program_.row_high()[row] - constant);
  }
  for (const auto& curve : curves_) {
    const double lower = program_.lower()[static_cast<std::size_t>(curve.row->of)];
    lp.add(curve.row->of, 1.0);
    for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
      lp.add(curve.first_part + static_cast<int>(m), -1.0);
    }
    lp.end_row(lower, lower);
  }
  for (const auto& [n, gradient] : norm_rows_) {
    double constant = 0.0;
    const auto& variables = program_.norms()[n].variables;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      constant += write(lp, variables[i], -gradient(static_cast<Eigen::Index>(i)));
    }
    lp.add(program_.variables() + static_cast<int>(n), 1.0);
    lp.end_row(-constant);
  }
  return lp;
}

void LinearRelaxation::add_columns(LinearProgram& lp) {
  for (std::size_t n = 0; n < first_gradients_.size(); ++n) {
    const auto& norm = program_.norms()[n];
    lp.add_column(0.0, infinity, norm.weight);
    for (std::size_t i = 0; i < norm.variables.size(); ++i) {
      lp.add_cost(norm.variables[i], norm.weight * first_gradients_[n](static_cast<Eigen::Index>(i)));
    }
  }
  for (auto& curve : curves_) {
    const double cost = lp.cost(curve.row->above);
    lp.bound(curve.row->above, 0.0, infinity);
    lp.add_constant(cost * curve.tangents.value_at_lower());
    curve.first_part = lp.columns();
    curve.pieces = curve.tangents.pieces();
    for (const auto& piece : curve.pieces) {
      lp.add_column(0.0, piece.width, cost * piece.slope);
    }
  }
}

// Writes coefficient * variable, with what stands above a curve in terms of its parts; gives the constant that remains.
double LinearRelaxation::write(LinearProgram& lp, int variable, double coefficient) const {
  lp.add(variable, coefficient);
  const int above = curve_above_[static_cast<std::size_t>(variable)];
  if (above < 0) {
    return 0.0;
  }
  const auto& curve = curves_[static_cast<std::size_t>(above)];
  for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
    lp.add(curve.first_part + static_cast<int>(m), coefficient * curve.pieces[m].slope);
  }
  return coefficient * curve.tangents.value_at_lower();
}

LinearRelaxation::Outcome LinearRelaxation::solve() {
  const LinearProgram lp = linear_program();
  if (const std::string why_not = lp.unfit(); !why_not.empty()) {
    return {.why_not = why_not, .lower_bound = -infinity, .x = {}};
  }
  const auto clp = lp.load();
  basis_.empty() ? start_without_prices(*clp) : start_from_prices(*clp);
  clp->dual();
  if (!clp->isProvenOptimal()) {
    return {.why_not = "Clp finds no optimum", .lower_bound = -infinity, .x = {}};
  }
  keep_prices(*clp);
  return {.why_not = "", .lower_bound = lp.lower_bound(*clp), .x = point(*clp)};
}

void LinearRelaxation::keep_prices(const ClpSimplex& clp) {
  basis_.clear();
  for (int column = 0; column < first_part(); ++column) {
    basis_.push_back(clp.getColumnStatus(column));
  }
  for (int row = 0; row < clp.numberRows(); ++row) {
    basis_.push_back(clp.getRowStatus(row));
  }
  for (std::size_t n = 0; n < curves_.size(); ++n) {
    auto& curve = curves_[n];
    const double price_of_value = clp.dualColumnSolution()[curve.row->above];
    const double price_of_argument = clp.dualRowSolution()[program_.rows() + static_cast<int>(n)];
    curve.slope = price_of_value > 0.0 ? -price_of_argument / price_of_value : -infinity;
    curve.basic.clear();
    for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
      if (clp.getColumnStatus(curve.first_part + static_cast<int>(m)) == ClpSimplex::basic) {
        curve.basic.push_back(curve.pieces[m].at);
      }
    }
  }
}

// A basis that is nearly dual feasible. Basic are the variable that each equation defines, the last part of each curve,
// and, in place of each row that alone holds back variables with a negative reduced cost, the one with the least. Where
// a reduced cost still has the wrong sign, the column mostly has two bounds, and the dual method moves it to the other
// one without a pivot.
void LinearRelaxation::start_without_prices(ClpSimplex& clp) const {
  clp.createStatus();
  std::vector<double> reduced(clp.objective(), clp.objective() + program_.variables());
  for (std::size_t n = 0; n < curves_.size(); ++n) {
    const int last_part = curves_[n].first_part + static_cast<int>(curves_[n].pieces.size()) - 1;
    make_basic(clp, last_part, program_.rows() + static_cast<int>(n));
    reduced[static_cast<std::size_t>(curves_[n].row->of)] += clp.objective()[last_part];
  }
  std::vector<const Expression::Term*> defined(static_cast<std::size_t>(program_.rows()), nullptr);
  for (int row = 0; row < program_.rows(); ++row) {
    if (clp.rowLower()[row] == clp.rowUpper()[row]) {
      defined[static_cast<std::size_t>(row)] = defined_by(clp, row);
    }
    if (const auto* term = defined[static_cast<std::size_t>(row)]) {
      make_basic(clp, term->variable, row);
    }
  }
  for (int row = program_.rows() - 1; row >= 0; --row) {  // what an equation defines stands in later ones
    if (const auto* term = defined[static_cast<std::size_t>(row)]) {
      subtract_price(reduced, program_.row(row), *term);
    }
  }
  for (int row = program_.rows() - 1; row >= 0; --row) {
    if (const auto* term = held_back(clp, row, reduced)) {
      make_basic(clp, term->variable, row);
      subtract_price(reduced, program_.row(row), *term);
    }
  }
}

// The first column of an equation that has no lower bound, or that a curve is of, and is not basic yet; else the last
// without an upper bound: what is left for it when the others are at their bounds. Null if there is none.
const Expression::Term* LinearRelaxation::defined_by(const ClpSimplex& clp, int row) const {
  const Expression::Term* defined = nullptr;
  for (const auto& term : program_.row(row)) {
    const int column = term.variable;
    if (clp.getColumnStatus(column) == ClpSimplex::basic) {
      continue;
    }
    if (clp.columnLower()[column] == -COIN_DBL_MAX || has_curve_[static_cast<std::size_t>(column)]) {
      return &term;
    }
    defined = clp.columnUpper()[column] == COIN_DBL_MAX ? &term : defined;
  }
  return defined;
}

// The column of the least reduced cost of those that only the row, which is still basic, holds back; null if there is
// none.
const Expression::Term* LinearRelaxation::held_back(const ClpSimplex& clp, int row,
                                                    const std::vector<double>& reduced) const {
  constexpr double negligible = 1e-9;
  const Expression::Term* held = nullptr;
  if (clp.getRowStatus(row) != ClpSimplex::basic || clp.rowUpper()[row] == COIN_DBL_MAX) {
    return held;
  }
  double least = -negligible;
  for (const auto& term : program_.row(row)) {
    const double cost = reduced[static_cast<std::size_t>(term.variable)];
    if (term.coefficient > 0.0 && cost < least && clp.columnUpper()[term.variable] == COIN_DBL_MAX &&
        clp.getColumnStatus(term.variable) != ClpSimplex::basic) {
      held = &term;
      least = cost;
    }
  }
  return held;
}

void LinearRelaxation::start_from_prices(ClpSimplex& clp) const {
  clp.createStatus();
  const int columns = first_part();
  for (int i = 0; i < std::ssize(basis_); ++i) {
    const auto status = static_cast<ClpSimplex::Status>(basis_[static_cast<std::size_t>(i)]);
    i < columns ? clp.setColumnStatus(i, status) : clp.setRowStatus(i - columns, status);
  }
  for (const auto& curve : curves_) {
    for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
      const auto& piece = curve.pieces[m];
      const bool last = m + 1 == curve.pieces.size();
      const auto status = std::ranges::find(curve.basic, piece.at) != curve.basic.end() ? ClpSimplex::basic
                          : piece.slope < curve.slope && !last                          ? ClpSimplex::atUpperBound
                                                                                        : ClpSimplex::atLowerBound;
      clp.setColumnStatus(curve.first_part + static_cast<int>(m), status);
    }
  }
}

Eigen::VectorXd LinearRelaxation::point(const ClpSimplex& clp) const {
  const double* columns = clp.primalColumnSolution();
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(columns, program_.variables());
  for (const auto& curve : curves_) {
    double& above = x(curve.row->above);
    above += curve.tangents.value_at_lower();
    for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
      above += curve.pieces[m].slope * columns[curve.first_part + static_cast<int>(m)];
    }
  }
  return x;
}

void LinearRelaxation::refine(const Eigen::VectorXd& x) {
  for (auto& curve : curves_) {
    if (curve.slope > -infinity) {
      curve.tangents.add_around(curve.slope);
    }
    curve.tangents.add(x(curve.row->of));
  }
  for (std::size_t n = 0; n < first_gradients_.size(); ++n) {
    const auto& norm = program_.norms()[n];
    norm_rows_.push_back({n, norm.gradient(values_of(norm.variables, x)) - first_gradients_[n]});
  }
}

}  // namespace evbal

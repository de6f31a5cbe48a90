#include "coordinator/convex/linear_relaxation.hpp"

#include <ClpDualRowDantzig.hpp>
#include <ClpSimplex.hpp>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace evbal {
namespace {

bool contains(const std::vector<std::uint64_t>& sorted, std::uint64_t key) {
  return std::ranges::binary_search(sorted, key);
}

// Of the names of columns or rows; equal ones that follow each other count on.
template <class NameOf>
std::vector<std::uint64_t> keys_of(int count, const NameOf& name_of) {
  std::vector<std::uint64_t> keys;
  std::uint64_t last = 0;
  std::uint64_t repeated = 0;
  for (int n = 0; n < count; ++n) {
    const std::uint64_t key = key_of(name_of(n));
    repeated = n > 0 && key == last ? repeated + 1 : 0;
    last = key;
    keys.push_back(key + repeated);
  }
  return keys;
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

// The linear program solved from the start; null if that takes more iterations than a start afresh should.
//
// Prices of another program are not quite dual feasible. Clp supposes bounds where there are none, so far out that it
// would leave the dual method for the primal one; not so if they are nearer, and it takes them away in the end. Then
// mostly few pivots are left, which do not repay the weights of steepest edges: the largest violation goes first.
std::shared_ptr<ClpSimplex> LinearRelaxation::solved_from_prices(const LinearProgram& lp) const {
  constexpr double supposed_bound = 1e4;
  auto clp = lp.load();
  ClpDualRowDantzig largest_violation;
  clp->setDualRowPivotAlgorithm(largest_violation);
  clp->setDualBound(supposed_bound);
  clp->setMaximumIterations(lp.rows() + lp.columns());
  start_from_prices(*clp);
  clp->dual();
  return clp->isProvenOptimal() ? clp : nullptr;
}

void LinearRelaxation::start_from_prices(ClpSimplex& clp) const {
  clp.createStatus();
  for (int column = 0; column < std::ssize(columns_); ++column) {
    const Place place = columns_[static_cast<std::size_t>(column)];
    if (place == Place::basic) {
      clp.setColumnStatus(column, ClpSimplex::basic);
    } else if (place == Place::upper && clp.columnUpper()[column] < COIN_DBL_MAX) {
      clp.setColumnStatus(column, ClpSimplex::atUpperBound);
    } else if (clp.columnLower()[column] == -COIN_DBL_MAX) {
      clp.setColumnStatus(column, ClpSimplex::isFree);
    }
  }
  for (int row = 0; row < std::ssize(binding_); ++row) {
    if (binding_[static_cast<std::size_t>(row)]) {
      clp.setRowStatus(row, clp.rowUpper()[row] < COIN_DBL_MAX ? ClpSimplex::atUpperBound : ClpSimplex::atLowerBound);
    }
  }
  for (const auto& curve : curves_) {
    if (curve.start) {
      start_from_prices(clp, curve);
    }
  }
}

// Pieces that fall faster than prices ask for are full.
void LinearRelaxation::start_from_prices(ClpSimplex& clp, const Curve& curve) const {
  for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
    const auto& piece = curve.pieces[m];
    const bool is_last = m + 1 == curve.pieces.size();
    const auto status = std::ranges::find(curve.start->basic, piece.at) != curve.start->basic.end() ? ClpSimplex::basic
                        : piece.slope < curve.start->slope && !is_last ? ClpSimplex::atUpperBound
                                                                       : ClpSimplex::atLowerBound;
    clp.setColumnStatus(curve.first_part + static_cast<int>(m), status);
  }
}

// Columns that the start does not know stay at their lower bounds, rows that it does not know do not bind.
void LinearRelaxation::place(const Start& start) {
  if (!start.has_basis()) {
    return;
  }
  for (const auto key : column_keys_) {
    columns_.push_back(contains(start.basic, key)      ? Place::basic
                       : contains(start.at_upper, key) ? Place::upper
                                                       : Place::lower);
  }
  for (const auto key : row_keys_) {
    binding_.push_back(contains(start.binding, key));
  }
}

void LinearRelaxation::remember(const ClpSimplex& clp) {
  columns_.clear();
  for (int column = 0; column < std::ssize(column_keys_); ++column) {
    const auto status = clp.getColumnStatus(column);
    columns_.push_back(status == ClpSimplex::basic          ? Place::basic
                       : status == ClpSimplex::atUpperBound ? Place::upper
                                                            : Place::lower);
  }
  binding_.clear();
  for (int row = 0; row < clp.numberRows(); ++row) {
    binding_.push_back(clp.getRowStatus(row) != ClpSimplex::basic);
  }
  for (std::size_t n = 0; n < curves_.size(); ++n) {
    curves_[n].start = end_of(clp, static_cast<int>(n));
  }
}

Start LinearRelaxation::start() const {
  Start end;
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (columns_[column] == Place::basic) {
      end.basic.push_back(column_keys_[column]);
    } else if (columns_[column] == Place::upper) {
      end.at_upper.push_back(column_keys_[column]);
    }
  }
  for (std::size_t row = 0; row < binding_.size(); ++row) {
    if (binding_[row]) {
      end.binding.push_back(key_of_row(static_cast<int>(row)));
    }
  }
  for (auto* keys : {&end.basic, &end.at_upper, &end.binding}) {
    std::ranges::sort(*keys);
  }
  for (const auto& curve : curves_) {
    if (curve.start) {
      end.curves.push_back(*curve.start);
    }
  }
  std::ranges::sort(end.curves, {}, &CurveStart::above);
  return end;
}

CurveStart LinearRelaxation::end_of(const ClpSimplex& clp, int n) const {
  const Curve& curve = curves_[static_cast<std::size_t>(n)];
  const double price_of_value = clp.dualColumnSolution()[curve.row->above];
  const double price_of_argument = clp.dualRowSolution()[program_.rows() + n];
  CurveStart end{.above = column_keys_[static_cast<std::size_t>(curve.row->above)],
                 .at = clp.primalColumnSolution()[curve.row->of],
                 .slope = price_of_value > 0.0 ? -price_of_argument / price_of_value : -ConvexProgram::infinity,
                 .basic = {}};
  for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
    if (clp.getColumnStatus(curve.first_part + static_cast<int>(m)) == ClpSimplex::basic) {
      end.basic.push_back(curve.pieces[m].at);
    }
  }
  return end;
}

void LinearRelaxation::name_columns_and_rows() {
  const auto& program = program_;
  column_keys_ = keys_of(program.variables(), [&](int variable) { return program.name_of({variable}); });
  for (int n = 0; n < std::ssize(program.norms()); ++n) {
    column_keys_.push_back(key_of({"height", n}));
  }
  row_keys_ = keys_of(program.rows(), [&](int row) { return program.name_of_row(row); });
  for (const auto& curve : program.curves()) {
    row_keys_.push_back(column_keys_[static_cast<std::size_t>(curve.above)]);
  }
}

// Those after the curves' are the norms' tangents.
std::uint64_t LinearRelaxation::key_of_row(int row) const {
  const auto known = static_cast<int>(row_keys_.size());
  return row < known ? row_keys_[static_cast<std::size_t>(row)] : key_of({"tangent", row - known});
}

}  // namespace evbal

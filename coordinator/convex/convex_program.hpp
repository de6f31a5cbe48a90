#pragma once

#include "common/eigen.hpp"
#include "coordinator/convex/convex_function.hpp"
#include "coordinator/convex/expression.hpp"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// weight * || Sigma^(1/2) Z ||  with  Sigma = diag(deviation)^2 + factors factors'.
struct NormTerm {
  double weight = 0.0;         ///< > 0
  std::vector<int> variables;  ///< Z
  Eigen::VectorXd deviation;   ///< > 0
  Eigen::MatrixXd factors;     ///< variables x rank

  /// || Sigma^(1/2) z ||
  double norm(const Eigen::VectorXd& z) const;

  /// Sigma z / || Sigma^(1/2) z ||, and zero at zero: the slope of a tangent, which passes through zero.
  Eigen::VectorXd gradient(const Eigen::VectorXd& z) const;
};

/// above >= function(of)
struct CurveRow {
  int above = 0;               ///< variable that bounds the function from above
  int of = 0;                  ///< variable that the function is of
  ConvexFunctionPtr function;  ///< the function
};

/// How far a point is from satisfying a program, and where: "supply[3], step 1", "upper bound of u[0], step 0",
/// "curve of Z[2], step 1".
struct Violation {
  double amount = 0.0;  ///< infinite where something is not a finite number
  std::string where;    ///< empty if the amount is 0
  std::string unit;     ///< of the amount: the program's, but for curves
};

/// A part of the objective, and its value at some point.
struct CostTerm {
  std::string name;   ///< as minimise() was given it
  double cost = 0.0;  ///< in the unit of the objective
};

/// A convex program, for whichever engine:
///
///     min  constant + cost'x + sum of norms    s.t.  low <= A x <= high,  lower <= x <= upper,  curve rows
///
/// It is written like the equations of a model, by expressions, their comparisons, and names for messages:
///
///     const Variables S = program.add_block({"S", k}, N);
///     program.add(S[i] == V[i] + in[i] - out[i], {"supply", k, i});
///     program.minimise("km", km);
///
/// Rows are sparse, stored one after another with ascending variables.
class ConvexProgram {
 public:
  /// No bound.
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Variables added together.
  struct Block {
    Name name;      ///< of the first; the others of several count on from it
    int first = 0;  ///< index of the first
    int size = 0;   ///< number of variables
  };

  /// `unit` is what variables and rows are measured in, for messages: "vehicles".
  explicit ConvexProgram(std::string unit = "") : unit_(std::move(unit)) {}

  /// A new variable within [lower, upper].
  Variable add_variable(const Name& name, double lower = 0.0, double upper = infinity);

  /// `size` new variables within [lower, upper].
  Variables add_block(const Name& name, int size, double lower = 0.0, double upper = infinity);

  /// Tightens the bounds of a variable; those that it has leave some of [lower, upper].
  void bound(Variable variable, double lower, double upper);

  /// Adds a row, unless it holds whatever the variables are.
  void add(const Constraint& constraint, const Name& name = "a row");

  /// above >= function(of), where `of` has a finite lower bound in the function's domain, and `above` stands above no
  /// other curve and has no bound that would keep it from the curve.
  void at_least_curve(Variable above, Variable of, ConvexFunctionPtr function);

  /// Adds to the objective. `term` says which part of it this is.
  void minimise(std::string_view term, const Expression& cost);

  /// Adds  price * function(of)  over  of >= 0  to the objective; gives the variable, called `name`, that stands for
  /// the function's value.
  Variable minimise_curve(std::string_view term, double price, Variable of, ConvexFunctionPtr function,
                          const Name& name);

  /// Adds a norm to the objective.
  void minimise_norm(std::string_view term, NormTerm norm);

  /// Cost that keeps the program feasible, the term "penalty"; left out of the scale of a relative gap.
  void penalise(const Expression& cost);

  /// Number of variables.
  int variables() const { return static_cast<int>(cost_.size()); }
  /// Number of linear rows.
  int rows() const { return static_cast<int>(row_low_.size()); }
  /// All variables, in the order of their indices.
  const std::vector<Block>& blocks() const { return blocks_; }
  /// Bounds by variable.
  const std::vector<double>& lower() const { return lower_; }
  /// Bounds by variable.
  const std::vector<double>& upper() const { return upper_; }
  /// Linear cost by variable.
  const std::vector<double>& cost() const { return cost_; }
  /// Constant part of the objective.
  double constant() const { return constant_; }
  const std::vector<int>& row_start() const { return row_start_; }  ///< rows() + 1
  /// The rows' entries, row after row.
  const std::vector<Expression::Term>& entries() const { return entries_; }
  /// The entries of one row.
  std::span<const Expression::Term> row(int row) const {
    return {entries_.begin() + row_start_[row], entries_.begin() + row_start_[row + 1]};
  }
  /// Lower sides by row.
  const std::vector<double>& row_low() const { return row_low_; }
  /// Upper sides by row.
  const std::vector<double>& row_high() const { return row_high_; }
  /// Rows with convex functions.
  const std::vector<CurveRow>& curves() const { return curves_; }
  /// Norms of the objective.
  const std::vector<NormTerm>& norms() const { return norms_; }

  /// The name of a variable.
  Name name_of(Variable variable) const;
  /// The name of a linear row.
  const Name& name_of_row(int row) const { return row_names_[row]; }

  /// The objective at a point.
  double objective(const Eigen::VectorXd& x) const;

  /// The objective by term, in the order in which terms were first named, a penalty last. The sum is objective(x) but
  /// for rounding.
  std::vector<CostTerm> cost_by_term(const Eigen::VectorXd& x) const;

  /// The part of the objective that penalise() put there.
  double penalty(const Eigen::VectorXd& x) const;

  /// The worst violation of any bound, row or curve row.
  Violation violation(const Eigen::VectorXd& x) const;

 private:
  /// What minimise() was told under one name.
  struct Term {
    std::string name;  ///< as minimise() was given it
    Expression cost;
    std::vector<int> norms;
  };

  Term& term(std::string_view name);
  void add_cost(const Expression& cost);

  std::string unit_;
  std::vector<Block> blocks_;
  std::vector<double> lower_;
  std::vector<double> upper_;
  std::vector<double> cost_;
  double constant_ = 0.0;
  std::vector<Name> row_names_;
  std::vector<int> row_start_ = {0};
  std::vector<Expression::Term> entries_;
  std::vector<double> row_low_;
  std::vector<double> row_high_;
  std::vector<CurveRow> curves_;
  std::vector<NormTerm> norms_;
  std::vector<Term> terms_;
  Expression penalty_;
};

/// The value of an expression at x.
double value_of(const Expression& expression, const Eigen::VectorXd& x);

/// The values of `variables` in x.
Eigen::VectorXd values_of(const std::vector<int>& variables, const Eigen::VectorXd& x);

}  // namespace evbal

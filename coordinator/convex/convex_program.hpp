#pragma once

#include "coordinator/convex/convex_function.hpp"

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

namespace evbal {

/// A variable of a ConvexProgram, by its position.
struct Variable {
  int index = 0;
};

using Variables = std::vector<Variable>;

/// constant + sum of coefficient * variable. Written like the equations of the model.
class Expression {
 public:
  struct Term {
    int variable = 0;
    double coefficient = 0.0;
  };

  Expression(double constant = 0.0) : constant_(constant) {}
  Expression(Variable variable) : terms_{{variable.index, 1.0}} {}

  /// Adds `coefficient * other`; a coefficient of zero adds nothing.
  Expression& add(double coefficient, const Expression& other);

  Expression& operator+=(const Expression& other) { return add(1.0, other); }
  Expression& operator-=(const Expression& other) { return add(-1.0, other); }

  const std::vector<Term>& terms() const { return terms_; }
  double constant() const { return constant_; }

 private:
  std::vector<Term> terms_;
  double constant_ = 0.0;
};

Expression operator+(Expression left, const Expression& right);
Expression operator-(Expression left, const Expression& right);
Expression operator*(double factor, const Expression& expression);

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
  int above = 0;
  int of = 0;
  ConvexFunctionPtr function;
};

/// "S2" for the block S of the second step (k = 1).
std::string label(std::string name, int k);

/// A convex program, for whichever engine:
///
///     min  constant + cost'x + sum of norms    s.t.  low <= A x <= high,  lower <= x <= upper,  curve rows
///
/// Rows are sparse, stored one after another with ascending variables.
class ConvexProgram {
 public:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Block {
    std::string name;
    int first = 0;
    int size = 0;
  };

  /// `size` new variables within [lower, upper]; the name serves messages.
  Variables add_block(const std::string& name, int size, double lower = 0.0, double upper = infinity);

  /// Tightens the bounds of a variable.
  void bound(Variable variable, double lower, double upper);

  void equal(const Expression& left, const Expression& right);
  void at_most(const Expression& left, const Expression& right);

  /// above >= function(of), where `of` has a finite lower bound in the function's domain, and `above` stands above no
  /// other curve and has no bound that would keep it from the curve.
  void at_least_curve(Variable above, Variable of, ConvexFunctionPtr function);

  void minimise(const Expression& cost);

  /// Adds  price * function(of)  over  of >= 0  to the cost; gives the variable that stands for the function's value.
  Variable minimise_curve(const std::string& name, double price, Variable of, ConvexFunctionPtr function);

  /// Cost that keeps the program feasible; left out of the scale of a relative gap.
  void penalise(const Expression& cost);

  void minimise_norm(NormTerm term);

  int variables() const { return static_cast<int>(cost_.size()); }
  int rows() const { return static_cast<int>(row_low_.size()); }
  const std::vector<Block>& blocks() const { return blocks_; }
  const std::vector<double>& lower() const { return lower_; }
  const std::vector<double>& upper() const { return upper_; }
  const std::vector<double>& cost() const { return cost_; }
  double constant() const { return constant_; }
  const std::vector<int>& row_start() const { return row_start_; }  ///< rows() + 1
  const std::vector<Expression::Term>& entries() const { return entries_; }
  const std::vector<double>& row_low() const { return row_low_; }
  const std::vector<double>& row_high() const { return row_high_; }
  const std::vector<CurveRow>& curves() const { return curves_; }
  const std::vector<NormTerm>& norms() const { return norms_; }

  double objective(const Eigen::VectorXd& x) const;

  /// The part of the objective that penalise() put there.
  double penalty(const Eigen::VectorXd& x) const;

  /// Largest violation of any bound, row or curve row; infinite if x is not finite.
  double violation(const Eigen::VectorXd& x) const;

 private:
  void add_row(double low, const Expression& expression, double high);
  void add_cost(const Expression& cost);

  std::vector<Block> blocks_;
  std::vector<double> lower_;
  std::vector<double> upper_;
  std::vector<double> cost_;
  double constant_ = 0.0;
  std::vector<int> row_start_ = {0};
  std::vector<Expression::Term> entries_;
  std::vector<double> row_low_;
  std::vector<double> row_high_;
  std::vector<CurveRow> curves_;
  std::vector<NormTerm> norms_;
  Expression penalty_;
};

/// The values of `variables` in x.
Eigen::VectorXd values_of(const std::vector<int>& variables, const Eigen::VectorXd& x);

}  // namespace evbal

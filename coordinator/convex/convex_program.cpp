#include "coordinator/convex/convex_program.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evbal {
namespace {

double evaluate(const Expression& expression, const Eigen::VectorXd& x) {
  double value = expression.constant();
  for (const auto& [variable, coefficient] : expression.terms()) {
    value += coefficient * x(variable);
  }
  return value;
}

// Ascending variables, each once, none with coefficient zero.
std::vector<Expression::Term> merged(std::vector<Expression::Term> terms) {
  std::ranges::stable_sort(terms, {}, &Expression::Term::variable);
  std::vector<Expression::Term> result;
  for (const auto& term : terms) {
    if (!result.empty() && result.back().variable == term.variable) {
      result.back().coefficient += term.coefficient;
    } else {
      result.push_back(term);
    }
  }
  std::erase_if(result, [](const auto& term) { return term.coefficient == 0.0; });
  return result;
}

}  // namespace

Expression& Expression::add(double coefficient, const Expression& other) {
  if (coefficient == 0.0) {
    return *this;
  }
  constant_ += coefficient * other.constant_;
  for (const auto& term : other.terms_) {
    terms_.push_back({term.variable, coefficient * term.coefficient});
  }
  return *this;
}

Expression operator+(Expression left, const Expression& right) {
  return left += right;
}

Expression operator-(Expression left, const Expression& right) {
  return left -= right;
}

Expression operator*(double factor, const Expression& expression) {
  return Expression().add(factor, expression);
}

std::string label(std::string name, int k) {
  name += std::to_string(k + 1);
  return name;
}

double NormTerm::norm(const Eigen::VectorXd& z) const {
  return std::sqrt((deviation.array() * z.array()).square().sum() + (factors.transpose() * z).squaredNorm());
}

Eigen::VectorXd NormTerm::gradient(const Eigen::VectorXd& z) const {
  const double length = norm(z);
  if (length == 0.0) {
    return Eigen::VectorXd::Zero(z.size());
  }
  return ((deviation.array().square() * z.array()).matrix() + factors * (factors.transpose() * z)) / length;
}

Variables ConvexProgram::add_block(const std::string& name, int size, double lower, double upper) {
  EVBAL_EXPECT(size >= 0 && lower <= upper, "a size of at least zero and bounds in order");
  const int first = variables();
  blocks_.push_back({name, first, size});
  Variables block;
  for (int i = 0; i < size; ++i) {
    block.push_back({first + i});
    lower_.push_back(lower);
    upper_.push_back(upper);
    cost_.push_back(0.0);
  }
  return block;
}

void ConvexProgram::bound(Variable variable, double lower, double upper) {
  EVBAL_EXPECT(lower <= upper, "bounds in order");
  lower_[static_cast<std::size_t>(variable.index)] = lower;
  upper_[static_cast<std::size_t>(variable.index)] = upper;
}

void ConvexProgram::add_row(double low, const Expression& expression, double high) {
  const auto terms = merged(expression.terms());
  low -= expression.constant();
  high -= expression.constant();
  if (terms.empty() && low <= 0.0 && high >= 0.0) {
    return;
  }
  entries_.insert(entries_.end(), terms.begin(), terms.end());
  row_start_.push_back(static_cast<int>(entries_.size()));
  row_low_.push_back(low);
  row_high_.push_back(high);
}

void ConvexProgram::equal(const Expression& left, const Expression& right) {
  add_row(0.0, left - right, 0.0);
}

void ConvexProgram::at_most(const Expression& left, const Expression& right) {
  add_row(-infinity, left - right, 0.0);
}

void ConvexProgram::at_least_curve(Variable above, Variable of, ConvexFunctionPtr function) {
  EVBAL_EXPECT(std::isfinite(lower_[static_cast<std::size_t>(of.index)]),
               "a curve of a variable with a finite lower bound");
  curves_.push_back({above.index, of.index, std::move(function)});
}

void ConvexProgram::add_cost(const Expression& cost) {
  constant_ += cost.constant();
  for (const auto& [variable, coefficient] : cost.terms()) {
    cost_[static_cast<std::size_t>(variable)] += coefficient;
  }
}

void ConvexProgram::minimise(const Expression& cost) {
  add_cost(cost);
}

Variable ConvexProgram::minimise_curve(const std::string& name, double price, Variable of, ConvexFunctionPtr function) {
  const Variable value = add_block(name, 1).front();
  bound(of, 0.0, infinity);
  at_least_curve(value, of, std::move(function));
  minimise(price * Expression(value));
  return value;
}

void ConvexProgram::penalise(const Expression& cost) {
  add_cost(cost);
  penalty_ += cost;
}

void ConvexProgram::minimise_norm(NormTerm term) {
  EVBAL_EXPECT(term.weight > 0.0 && term.deviation.size() == std::ssize(term.variables),
               "a weight above zero and a deviation of each variable");
  EVBAL_EXPECT(term.factors.rows() == term.deviation.size() && (term.deviation.array() > 0.0).all(),
               "a row of factors of each variable and deviations above zero");
  norms_.push_back(std::move(term));
}

double ConvexProgram::objective(const Eigen::VectorXd& x) const {
  double value = constant_ + Eigen::Map<const Eigen::VectorXd>(cost_.data(), variables()).dot(x);
  for (const auto& term : norms_) {
    value += term.weight * term.norm(values_of(term.variables, x));
  }
  return value;
}

double ConvexProgram::penalty(const Eigen::VectorXd& x) const {
  return evaluate(penalty_, x);
}

double ConvexProgram::violation(const Eigen::VectorXd& x) const {
  EVBAL_EXPECT(x.size() == variables(), "a value of each variable");
  if (!x.allFinite()) {
    return infinity;
  }
  double worst = 0.0;
  const auto within = [&worst](double low, double value, double high) {
    worst = std::max({worst, low - value, value - high});
  };
  for (std::size_t i = 0; i < cost_.size(); ++i) {
    within(lower_[i], x(static_cast<Eigen::Index>(i)), upper_[i]);
  }
  for (std::size_t row = 0; row < row_low_.size(); ++row) {
    double value = 0.0;
    for (int at = row_start_[row]; at < row_start_[row + 1]; ++at) {
      const auto& [variable, coefficient] = entries_[static_cast<std::size_t>(at)];
      value += coefficient * x(variable);
    }
    within(row_low_[row], value, row_high_[row]);
  }
  for (const auto& curve : curves_) {
    within(curve.function->around(x(curve.of)).value, x(curve.above), infinity);
  }
  return worst;
}

Eigen::VectorXd values_of(const std::vector<int>& variables, const Eigen::VectorXd& x) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(variables.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    values(i) = x(variables[static_cast<std::size_t>(i)]);
  }
  return values;
}

}  // namespace evbal

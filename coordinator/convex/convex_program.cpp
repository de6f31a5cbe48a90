#include "coordinator/convex/convex_program.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evbal {
namespace {

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

// The largest violation met so far. Only its place is kept, so that no name is composed but the worst one's.
struct Worst {
  enum class Place { nowhere, lower_bound, upper_bound, row, curve };

  void meet(double amount, Place met, int index) {
    if (std::isnan(amount)) {
      amount = ConvexProgram::infinity;
    }
    if (amount > violation) {
      violation = amount;
      place = met;
      at = index;
    }
  }

  double violation = 0.0;
  Place place = Place::nowhere;
  int at = 0;
};

std::string where(const Worst& worst, const ConvexProgram& program) {
  const auto variable = [&program](int index) { return program.name_of({index}).text(); };
  switch (worst.place) {
    case Worst::Place::nowhere:
      return "";
    case Worst::Place::lower_bound:
      return "lower bound of " + variable(worst.at);
    case Worst::Place::upper_bound:
      return "upper bound of " + variable(worst.at);
    case Worst::Place::row:
      return program.name_of_row(worst.at).text();
    case Worst::Place::curve:
      return "curve of " + variable(program.curves()[worst.at].above);
  }
  return "";
}

}  // namespace

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

Variable ConvexProgram::add_variable(const Name& name, double lower, double upper) {
  return add_block(name, 1, lower, upper)[0];
}

Variables ConvexProgram::add_block(const Name& name, int size, double lower, double upper) {
  EVBAL_EXPECT(size >= 0 && lower <= upper, "a size of at least zero and bounds in order");
  const int first = variables();
  blocks_.push_back({name, first, size});
  const auto end = cost_.size() + static_cast<std::size_t>(size);
  lower_.resize(end, lower);
  upper_.resize(end, upper);
  cost_.resize(end, 0.0);
  return {first, size};
}

void ConvexProgram::bound(Variable variable, double lower, double upper) {
  double& low = lower_[variable.index];
  double& high = upper_[variable.index];
  EVBAL_EXPECT(std::max(low, lower) <= std::min(high, upper), "bounds that leave some of those that there are");
  low = std::max(low, lower);
  high = std::min(high, upper);
}

void ConvexProgram::add(const Constraint& constraint, const Name& name) {
  const auto terms = merged(constraint.expression.terms());
  const double low = constraint.low - constraint.expression.constant();
  const double high = constraint.high - constraint.expression.constant();
  if (terms.empty() && low <= 0.0 && high >= 0.0) {
    return;
  }
  entries_.insert(entries_.end(), terms.begin(), terms.end());
  row_names_.push_back(name);
  row_start_.push_back(static_cast<int>(entries_.size()));
  row_low_.push_back(low);
  row_high_.push_back(high);
}

void ConvexProgram::at_least_curve(Variable above, Variable of, ConvexFunctionPtr function) {
  EVBAL_EXPECT(std::isfinite(lower_[of.index]), "a curve of a variable with a finite lower bound");
  EVBAL_EXPECT(upper_[above.index] == infinity, "a variable above a curve without an upper bound");
  curves_.push_back({above.index, of.index, std::move(function)});
}

ConvexProgram::Term& ConvexProgram::term(std::string_view name) {
  const auto found = std::ranges::find(terms_, name, &Term::name);
  return found != terms_.end() ? *found : terms_.emplace_back(Term{std::string(name), {}, {}});
}

void ConvexProgram::add_cost(const Expression& cost) {
  constant_ += cost.constant();
  for (const auto& [variable, coefficient] : cost.terms()) {
    cost_[variable] += coefficient;
  }
}

void ConvexProgram::minimise(std::string_view term_name, const Expression& cost) {
  add_cost(cost);
  term(term_name).cost += cost;
}

Variable ConvexProgram::minimise_curve(std::string_view term_name, double price, Variable of,
                                       ConvexFunctionPtr function, const Name& name) {
  const Variable value = add_variable(name);
  bound(of, 0.0, infinity);
  at_least_curve(value, of, std::move(function));
  minimise(term_name, price * value);
  return value;
}

void ConvexProgram::minimise_norm(std::string_view term_name, NormTerm norm) {
  EVBAL_EXPECT(norm.weight > 0.0 && norm.deviation.size() == std::ssize(norm.variables),
               "a weight above zero and a deviation of each variable");
  EVBAL_EXPECT(norm.factors.rows() == norm.deviation.size() && (norm.deviation.array() > 0.0).all(),
               "a row of factors of each variable and deviations above zero");
  term(term_name).norms.push_back(static_cast<int>(norms_.size()));
  norms_.push_back(std::move(norm));
}

void ConvexProgram::penalise(const Expression& cost) {
  add_cost(cost);
  penalty_ += cost;
}

Name ConvexProgram::name_of(Variable variable) const {
  EVBAL_EXPECT(0 <= variable.index && variable.index < variables(), "a variable of this program");
  const auto after = std::ranges::upper_bound(blocks_, variable.index, {}, &Block::first);
  // The last block that begins no later; those without a variable lie before it.
  const Block& block = *(after - 1);
  Name name = block.name;
  if (block.size > 1) {
    (name.i < 0 ? name.i : name.j) = variable.index - block.first;
  }
  return name;
}

double ConvexProgram::objective(const Eigen::VectorXd& x) const {
  double value = constant_ + Eigen::Map<const Eigen::VectorXd>(cost_.data(), variables()).dot(x);
  for (const auto& norm : norms_) {
    value += norm.weight * norm.norm(values_of(norm.variables, x));
  }
  return value;
}

std::vector<CostTerm> ConvexProgram::cost_by_term(const Eigen::VectorXd& x) const {
  std::vector<CostTerm> costs;
  for (const auto& [name, cost, norms] : terms_) {
    costs.push_back({name, value_of(cost, x)});
    for (const int at : norms) {
      const NormTerm& norm = norms_[at];
      costs.back().cost += norm.weight * norm.norm(values_of(norm.variables, x));
    }
  }
  if (!penalty_.terms().empty()) {
    costs.push_back({"penalty", penalty(x)});
  }
  return costs;
}

double ConvexProgram::penalty(const Eigen::VectorXd& x) const {
  return value_of(penalty_, x);
}

Violation ConvexProgram::violation(const Eigen::VectorXd& x) const {
  EVBAL_EXPECT(x.size() == variables(), "a value of each variable");
  for (int i = 0; i < variables(); ++i) {
    if (!std::isfinite(x(i))) {
      return {infinity, name_of({i}).text(), unit_};
    }
  }
  Worst worst;
  for (int i = 0; i < variables(); ++i) {
    worst.meet(lower_[i] - x(i), Worst::Place::lower_bound, i);
    worst.meet(x(i) - upper_[i], Worst::Place::upper_bound, i);
  }
  for (int row = 0; row < rows(); ++row) {
    double value = 0.0;
    for (int at = row_start_[row]; at < row_start_[row + 1]; ++at) {
      const auto& [variable, coefficient] = entries_[at];
      value += coefficient * x(variable);
    }
    worst.meet(std::max(row_low_[row] - value, value - row_high_[row]), Worst::Place::row, row);
  }
  for (int n = 0; n < std::ssize(curves_); ++n) {
    const CurveRow& curve = curves_[n];
    worst.meet(curve.function->around(x(curve.of)).value - x(curve.above), Worst::Place::curve, n);
  }
  return {worst.violation, where(worst, *this), worst.place == Worst::Place::curve ? "" : unit_};
}

double value_of(const Expression& expression, const Eigen::VectorXd& x) {
  double value = expression.constant();
  for (const auto& [variable, coefficient] : expression.terms()) {
    value += coefficient * x(variable);
  }
  return value;
}

Eigen::VectorXd values_of(const std::vector<int>& variables, const Eigen::VectorXd& x) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(variables.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    values(i) = x(variables[i]);
  }
  return values;
}

}  // namespace evbal

#include "coordinator/convex/expression.hpp"

#include <limits>

namespace evbal {

std::string Name::text() const {
  std::string text = what;
  if (i >= 0) {
    text += '[' + std::to_string(i) + (j >= 0 ? ',' + std::to_string(j) : "") + ']';
  }
  if (step >= 0) {
    text += ", step " + std::to_string(step);
  }
  return text;
}

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

Constraint operator==(const Expression& left, const Expression& right) {
  return {.expression = left - right, .low = 0.0, .high = 0.0};
}

Constraint operator<=(const Expression& left, const Expression& right) {
  return {.expression = left - right, .low = -std::numeric_limits<double>::infinity(), .high = 0.0};
}

Constraint operator>=(const Expression& left, const Expression& right) {
  return right <= left;
}

}  // namespace evbal

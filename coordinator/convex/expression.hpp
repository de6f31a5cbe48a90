#pragma once

#include "common/contract.hpp"

#include <string>
#include <vector>

namespace evbal {

/// What a variable or a row is called in messages: Name("supply", 1, 3) reads "supply[3], step 1". All numbers count
/// from 0; what is -1 is left out.
struct Name {
  Name(std::string name, int of_step = -1, int first = -1, int second = -1)
      : what(std::move(name)), step(of_step), i(first), j(second) {}
  Name(const char* name, int of_step = -1, int first = -1, int second = -1)
      : Name(std::string(name), of_step, first, second) {}

  std::string text() const;

  std::string what;
  int step;  ///< of the horizon
  int i;
  int j;
};

/// A variable of a ConvexProgram, by its position.
struct Variable {
  int index = 0;
};

/// Variables that stand one after another in a program: S[0], S[1], ...
class Variables {
 public:
  Variables() = default;
  Variables(int first, int size) : first_(first), size_(size) {}

  int size() const { return size_; }

  Variable operator[](int i) const {
    EVBAL_EXPECT(0 <= i && i < size_, "an index within the block");
    return {first_ + i};
  }

 private:
  int first_ = 0;
  int size_ = 0;
};

/// constant + sum of coefficient * variable. Numbers and variables are expressions, too.
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

/// low <= expression <= high, made by comparing two expressions: `S[i] == V[i] + in[i] - out[i]`.
struct Constraint {
  Expression expression;
  double low = 0.0;
  double high = 0.0;
};

Constraint operator==(const Expression& left, const Expression& right);
Constraint operator<=(const Expression& left, const Expression& right);
Constraint operator>=(const Expression& left, const Expression& right);

}  // namespace evbal

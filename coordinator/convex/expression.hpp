#pragma once

#include "common/contract.hpp"

#include <string>
#include <vector>

namespace evbal {

/// What a variable or a row is called in messages: Name("supply", 1, 3) reads "supply[3], step 1". All numbers count
/// from 0; what is -1 is left out.
struct Name {
  /// `of_step`: of the horizon; `first`, `second`: such as region and destination.
  Name(std::string name, int of_step = -1, int first = -1, int second = -1)
      : what(std::move(name)), step(of_step), i(first), j(second) {}
  /// The same.
  Name(const char* name, int of_step = -1, int first = -1, int second = -1)
      : Name(std::string(name), of_step, first, second) {}

  /// As messages show it.
  std::string text() const;

  std::string what;  ///< in a word
  int step;          ///< of the horizon
  int i;             ///< first index
  int j;             ///< second index
};

/// A variable of a ConvexProgram, by its position.
struct Variable {
  int index = 0;  ///< in the program, from 0
};

/// Variables that stand one after another in a program: S[0], S[1], ...
class Variables {
 public:
  Variables() = default;
  /// `size` variables, of which the first has the index `first` in the program.
  Variables(int first, int size) : first_(first), size_(size) {}

  /// Number of variables.
  int size() const { return size_; }

  /// The variable of this position, from 0.
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
  /// A variable times a number.
  struct Term {
    int variable = 0;          ///< its index
    double coefficient = 0.0;  ///< of the variable
  };

  /// A number.
  Expression(double constant = 0.0) : constant_(constant) {}
  /// A variable.
  Expression(Variable variable) : terms_{{variable.index, 1.0}} {}

  /// Adds `coefficient * other`; a coefficient of zero adds nothing.
  Expression& add(double coefficient, const Expression& other);

  /// Adds another.
  Expression& operator+=(const Expression& other) { return add(1.0, other); }
  /// Subtracts another.
  Expression& operator-=(const Expression& other) { return add(-1.0, other); }

  /// In the order in which they were added.
  const std::vector<Term>& terms() const { return terms_; }
  /// What is added to the terms.
  double constant() const { return constant_; }

 private:
  std::vector<Term> terms_;
  double constant_ = 0.0;
};

/// The sum.
Expression operator+(Expression left, const Expression& right);
/// The difference.
Expression operator-(Expression left, const Expression& right);
/// The multiple.
Expression operator*(double factor, const Expression& expression);

/// low <= expression <= high, made by comparing two expressions: `S[i] == V[i] + in[i] - out[i]`.
struct Constraint {
  Expression expression;  ///< that is bounded
  double low = 0.0;       ///< lower bound
  double high = 0.0;      ///< upper bound
};

Constraint operator==(const Expression& left, const Expression& right);  ///< left = right
Constraint operator<=(const Expression& left, const Expression& right);  ///< left <= right
Constraint operator>=(const Expression& left, const Expression& right);  ///< left >= right

}  // namespace evbal

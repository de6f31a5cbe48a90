#pragma once

#include <memory>

namespace evbal {

/// A convex function of one variable with two derivatives; engines see nothing else of it.
class ConvexFunction {
 public:
  /// The function near a point.
  struct Expansion {
    double value = 0.0;      ///< of the function
    double slope = 0.0;      ///< first derivative
    double curvature = 0.0;  ///< >= 0
  };

  ConvexFunction() = default;
  ConvexFunction(const ConvexFunction&) = delete;
  ConvexFunction& operator=(const ConvexFunction&) = delete;
  virtual ~ConvexFunction() = default;

  /// Value and derivatives at `at`, which lies within the bounds of the variable that the function is used on.
  virtual Expansion around(double at) const = 0;
};

/// A function that several rows may share.
using ConvexFunctionPtr = std::shared_ptr<const ConvexFunction>;

/// y -> (y + eps)^(-a) for y >= 0 (docs/model.md, section 2; paper, [quality_charging_one]); a > 0, eps > 0.
ConvexFunctionPtr inverse_power(double eps, double a);

/// x -> f(slope x + offset)
ConvexFunctionPtr of_line(ConvexFunctionPtr f, double slope, double offset);

}  // namespace evbal

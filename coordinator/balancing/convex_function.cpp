#include "coordinator/balancing/convex_function.hpp"

#include <cassert>
#include <cmath>

namespace evbal {
namespace {

class InversePower final : public ConvexFunction {
 public:
  InversePower(double eps, double a) : eps_(eps), a_(a) { assert(eps > 0.0 && a > 0.0); }

  Jet around(double at) const override {
    const double base = at + eps_;
    const double value = std::pow(base, -a_);
    return {.value = value, .slope = -a_ * value / base, .curvature = a_ * (a_ + 1.0) * value / (base * base)};
  }

 private:
  double eps_;
  double a_;
};

}  // namespace

ConvexFunctionPtr inverse_power(double eps, double a) {
  return std::make_shared<InversePower>(eps, a);
}

}  // namespace evbal

#include "coordinator/convex/convex_function.hpp"

#include "common/contract.hpp"

#include <cmath>
#include <utility>

namespace evbal {
namespace {

class InversePower final : public ConvexFunction {
 public:
  InversePower(double eps, double a) : eps_(eps), a_(a) { EVBAL_EXPECT(eps > 0.0 && a > 0.0, "eps and a above zero"); }

  Expansion around(double at) const override {
    const double base = at + eps_;
    const double value = std::pow(base, -a_);
    return {.value = value, .slope = -a_ * value / base, .curvature = a_ * (a_ + 1.0) * value / (base * base)};
  }

 private:
  double eps_;
  double a_;
};

class OfLine final : public ConvexFunction {
 public:
  OfLine(ConvexFunctionPtr f, double slope, double offset) : f_(std::move(f)), slope_(slope), offset_(offset) {}

  Expansion around(double at) const override {
    const Expansion expansion = f_->around(slope_ * at + offset_);
    return {.value = expansion.value,
            .slope = slope_ * expansion.slope,
            .curvature = slope_ * slope_ * expansion.curvature};
  }

 private:
  ConvexFunctionPtr f_;
  double slope_;
  double offset_;
};

}  // namespace

ConvexFunctionPtr inverse_power(double eps, double a) {
  return std::make_shared<InversePower>(eps, a);
}

ConvexFunctionPtr of_line(ConvexFunctionPtr f, double slope, double offset) {
  return std::make_shared<OfLine>(std::move(f), slope, offset);
}

}  // namespace evbal

#include "coordinator/balancing/worst_case.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

class WorstCaseShortage final : public ConvexFunction {
 public:
  WorstCaseShortage(double sigma, double g1, double g2) : sigma_(sigma), g1_(g1), g2_(g2) {}

  Expansion around(double at) const override { return worst_case_shortage(at, sigma_, g1_, g2_); }

 private:
  double sigma_;
  double g1_;
  double g2_;
};

}  // namespace

// psi(d) = (sqrt(v - 2 d m + d^2) - d + m) / 2,   v = g2 sigma^2,   m = sqrt(min(g1, g2)) sigma,
// and where d > 0:  m = min(m, v / (2 d)), which leaves  psi(d) = v / (4 d).
ConvexFunction::Expansion worst_case_shortage(double d, double sigma, double g1, double g2) {
  EVBAL_EXPECT(sigma > 0.0 && g1 >= 0.0 && g2 >= 0.0, "a deviation above zero and thresholds of at least zero");
  const double v = g2 * sigma * sigma;
  const double m = std::sqrt(std::min(g1, g2)) * sigma;
  if (v == 0.0) {
    return {.value = std::max(0.0, -d), .slope = d < 0.0 ? -1.0 : 0.0, .curvature = 0.0};
  }
  if (2.0 * d * m >= v) {
    return {.value = v / (4.0 * d), .slope = -v / (4.0 * d * d), .curvature = v / (2.0 * d * d * d)};
  }
  const double variance = std::max(0.0, v - m * m);
  const double root = std::sqrt(variance + (d - m) * (d - m));
  // sqrt(v - 2 d m + d^2) - d, without the cancellation of two large numbers
  const double excess = d > 0.0 ? (v - 2.0 * d * m) / (root + d) : root - d;
  return {.value = 0.5 * (excess + m),
          .slope = 0.5 * ((d - m) / root - 1.0),
          .curvature = 0.5 * variance / (root * root * root)};
}

ConvexFunctionPtr worst_case_shortage(double sigma, double g1, double g2) {
  return std::make_shared<WorstCaseShortage>(sigma, g1, g2);
}

}  // namespace evbal

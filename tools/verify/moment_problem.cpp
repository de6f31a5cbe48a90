#include "tools/verify/moment_problem.hpp"

#include "common/contract.hpp"
#include "common/error.hpp"

#include <ClpSimplex.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace evbal {

double moment_problem(double d, double sigma, double g1, double g2) {
  EVBAL_EXPECT(sigma > 0.0 && std::abs(d) <= 1e6 * sigma, "a deviation above zero and a margin within 1e6 of it");
  EVBAL_EXPECT(g1 >= 0.0 && g2 > 0.0, "thresholds of at least zero");
  constexpr double enough = 1e-8;
  constexpr int max_points = 200;
  constexpr double far = 1e4;  // in either direction, while the multipliers are still flat
  // In units of sigma. Rows: weights, mean, second moment.
  const double at = d / sigma;
  const double mean = std::sqrt(g1);
  const std::array low = {1.0, -mean, -COIN_DBL_MAX};
  const std::array high = {1.0, mean, g2};
  ClpSimplex clp;
  clp.setLogLevel(0);
  clp.scaling(0);
  clp.setPrimalTolerance(1e-10);
  clp.setDualTolerance(1e-10);
  clp.resize(3, 0);
  for (std::size_t row = 0; row < low.size(); ++row) {
    clp.setRowBounds(static_cast<int>(row), low[row], high[row]);
  }
  const auto add_point = [&](double x) {
    const std::array rows = {0, 1, 2};
    const std::array moments = {1.0, x, x * x};
    clp.addColumn(3, rows.data(), moments.data(), 0.0, COIN_DBL_MAX, -std::max(0.0, x - at));
  };
  for (const double x : {0.0, at, -std::sqrt(g2), std::sqrt(g2)}) {
    add_point(x);
  }
  for (int point = 0; point < max_points; ++point) {
    clp.primal();
    if (!clp.isProvenOptimal()) {
      throw run_failed("Clp finds no optimum of a moment problem");
    }
    const double* y = clp.dualRowSolution();
    const double curve = std::max(-y[2], 1e-12);
    // What a unit of weight at x gains; it peaks once on either side of d.
    const auto gain = [&](double x) { return std::max(0.0, x - at) + y[0] + y[1] * x + y[2] * x * x; };
    const double left = std::clamp(y[1] / (2.0 * curve), -far, far);
    const double right = std::clamp((1.0 + y[1]) / (2.0 * curve), -far, far);
    const double best = gain(left) > gain(right) ? left : right;
    if (gain(best) <= enough) {
      return -clp.objectiveValue() * sigma;
    }
    add_point(best);
  }
  throw run_failed("a moment problem does not settle");
}

}  // namespace evbal

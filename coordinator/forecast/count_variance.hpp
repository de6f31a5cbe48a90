#pragma once

#include "common/contract.hpp"
#include "common/eigen.hpp"

#include <algorithm>
#include <vector>

namespace evbal {

struct HeldOutDay;

/// Variance of counts around their forecast m, as of a negative binomial: linear m + quadratic m^2, per step ahead, the
/// last one for all further steps (docs/model.md, section 4).
struct CountVariance {
  std::vector<double> linear;     ///< at least one, each >= 0
  std::vector<double> quadratic;  ///< as many, each >= 0

  /// The variance around a forecast m, `lead` steps ahead from 0.
  double at(Eigen::Index lead, double m) const {
    EVBAL_EXPECT(!linear.empty() && linear.size() == quadratic.size(),
                 "as many linear as quadratic coefficients, at least one");
    const std::size_t k = std::min(static_cast<std::size_t>(lead), linear.size() - 1);
    return linear[k] * m + quadratic[k] * m * m;
  }
};

/// Least squares of squared forecast errors on m and m^2, each weighted by the inverse square of what a Poisson count
/// would give, over all regions and origins of `days`, for `leads` steps. Never less than a Poisson count's variance.
CountVariance fit_count_variance(const std::vector<HeldOutDay>& days, int leads);

}  // namespace evbal

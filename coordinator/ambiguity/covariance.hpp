#pragma once

#include "common/eigen.hpp"

namespace evbal {

/// Covariance as diagonal + low rank, diag(deviation)^2 + factors factors'.
struct Covariance {
  Eigen::VectorXd deviation;  ///< d, > 0
  Eigen::MatrixXd factors;    ///< d x rank

  /// The whole matrix.
  Eigen::MatrixXd dense() const;
};

/// Covariance of forecast errors from `residuals` (d x samples, samples >= 2), fit for fewer samples than dimensions:
/// correlations are shrunk towards none by the intensity that minimises the expected squared error (Ledoit and Wolf
/// 2004, with the unequal-variance target of Schaefer and Strimmer 2005); eigenvalues above what unrelated series would
/// show (Marchenko and Pastur) become factors, the rest is diagonal. Variances stay the samples' own, floored at
/// `floor`^2. Residuals are deviations already: no mean is taken off.
Covariance shrunk_covariance(const Eigen::MatrixXd& residuals, double floor);

}  // namespace evbal

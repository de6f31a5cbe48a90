#pragma once

#include "coordinator/ambiguity/moment_set.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace evbal {

/// Thresholds of a MomentSet.
struct Thresholds {
  double g1 = 0.0;
  double g2 = 1.0;
};

/// Covariance as diagonal + low rank, diag(deviation)^2 + factors factors'.
struct Covariance {
  Eigen::VectorXd deviation;  ///< d, > 0
  Eigen::MatrixXd factors;    ///< d x rank

  Eigen::MatrixXd dense() const;
};

/// Covariance of forecast errors from `residuals` (d x samples, samples >= 2), fit for fewer samples than dimensions:
/// correlations are shrunk towards none by the intensity that minimises the expected squared error (Ledoit and Wolf
/// 2004, with the unequal-variance target of Schaefer and Strimmer 2005); eigenvalues above what unrelated series would
/// show (Marchenko and Pastur) become factors, the rest is diagonal. Variances stay the samples' own, floored at
/// `floor`^2. Residuals are deviations already: no mean is taken off.
Covariance shrunk_covariance(const Eigen::MatrixXd& residuals, double floor);

/// Thresholds at confidence 1 - alpha by the bootstrap (model, section 5): `replicates` times, `resample` residuals are
/// drawn with replacement; of the statistics of their mean and second moment the ceil(replicates (1 - alpha))-th
/// order statistic is taken. Seeded: equal arguments give equal thresholds.
struct Bootstrap {
  int resample = 500;     ///< N_B
  int replicates = 1000;  ///< B
  double alpha = 0.25;    ///< alpha_h
  std::uint64_t seed = 0;
};
Thresholds bootstrap_thresholds(const Eigen::MatrixXd& residuals, const Covariance& covariance,
                                const Bootstrap& bootstrap);

/// Law of scaled forecast errors over the horizon, for any time of the day.
struct ResidualLaw {
  Covariance covariance;               ///< of N tau scaled errors, step-major
  std::vector<Thresholds> thresholds;  ///< entry k: of the first k + 1 steps

  int leads() const { return static_cast<int>(thresholds.size()); }
};

/// Fits the law of `residuals` (N leads x samples, step-major). Only `regions` vary; the others' errors are nil.
ResidualLaw fit_residual_law(const Eigen::MatrixXd& residuals, int leads, const std::vector<int>& regions,
                             const Bootstrap& bootstrap);

/// The set around a forecast: `mean` and `scale` are N x tau, tau at most the law's leads. Standard deviations are
/// floored at 0.1 (model, section 5); where `scale` is 0 the count is certain, up to a tiny deviation that keeps Sigma
/// regular.
MomentSet moment_set(const ResidualLaw& law, const Eigen::MatrixXd& mean, const Eigen::MatrixXd& scale);

}  // namespace evbal

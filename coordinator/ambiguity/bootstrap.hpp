#pragma once

#include "common/eigen.hpp"
#include "coordinator/ambiguity/covariance.hpp"

#include <cstdint>

namespace evbal {

/// Thresholds of a MomentSet.
struct Thresholds {
  double g1 = 0.0;  ///< on the mean
  double g2 = 1.0;  ///< on the second moment
};

/// How often residuals are drawn again, and how many at a time. Seeded: equal arguments give equal results, on any
/// number of processors.
struct Bootstrap {
  int resample = 500;      ///< N_B
  int replicates = 1000;   ///< B
  double alpha = 0.25;     ///< alpha_h
  std::uint64_t seed = 0;  ///< of the draws
};

/// Thresholds, and the standard errors that come of drawing only so many replicates.
struct BootstrapThresholds {
  Thresholds value;  ///< the thresholds
  Thresholds error;  ///< their standard errors
};

/// Thresholds at confidence 1 - alpha by the bootstrap (docs/model.md, section 5): `replicates` times, `resample`
/// residuals (columns, d x samples) are drawn with replacement; of the statistics of their mean and second moment the
/// ceil(replicates (1 - alpha))-th order statistic is taken.
BootstrapThresholds bootstrap_thresholds(const Eigen::MatrixXd& residuals, const Covariance& covariance,
                                         const Bootstrap& bootstrap);

/// Shares of draws that a MomentSet covers.
struct Coverage {
  double g1 = 0.0;    ///< whose mean lies within g1
  double g2 = 0.0;    ///< whose second moment lies within g2
  double both = 0.0;  ///< both
};

/// Held-out coverage (docs/model.md, section 5): of `replicates` draws of `resample` residuals, which are none of those
/// that `covariance` and `thresholds` were estimated from.
Coverage coverage(const Eigen::MatrixXd& residuals, const Covariance& covariance, const Thresholds& thresholds,
                  const Bootstrap& bootstrap);

}  // namespace evbal

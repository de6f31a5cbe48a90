#pragma once

#include "common/eigen.hpp"

namespace evbal {

/// Moment-based ambiguity set around a forecast (paper, [uncertain_delta]; docs/model.md, section 5):
/// all distributions of xi = mean + delta with  E[delta]' Sigma^-1 E[delta] <= g1  and  E[delta delta'] <= g2 Sigma,
/// where  Sigma = diag(deviation)^2 + factors factors'.
/// Vectors are stacked step-major over the horizon: entry (step k, region i) stands at k * N + i.
struct MomentSet {
  Eigen::VectorXd mean;       ///< N tau
  Eigen::VectorXd deviation;  ///< N tau, > 0: square root of the diagonal part
  Eigen::MatrixXd factors;    ///< N tau x rank, rank may be 0
  double g1 = 0.0;            ///< squared Mahalanobis threshold of the mean
  double g2 = 1.0;            ///< threshold of the second moment

  /// Standard deviations, sqrt of Sigma's diagonal, N tau.
  Eigen::VectorXd standard_deviation() const {
    return (deviation.array().square() + factors.array().square().rowwise().sum()).sqrt();
  }
};

}  // namespace evbal

#pragma once

#include "common/eigen.hpp"
#include "coordinator/ambiguity/bootstrap.hpp"
#include "coordinator/ambiguity/covariance.hpp"
#include "coordinator/ambiguity/moment_set.hpp"
#include "coordinator/forecast/forecaster.hpp"

#include <vector>

namespace evbal {

/// Distribution of scaled forecast errors over the horizon, for any time of the day.
struct ResidualDistribution {
  Covariance covariance;               ///< of N tau scaled errors, step-major
  std::vector<Thresholds> thresholds;  ///< entry k: of the first k + 1 steps
  double alarm = 0.0;                  ///< normalised innovation beyond which errors are no longer so distributed

  /// Steps ahead that it is known for.
  int leads() const { return static_cast<int>(thresholds.size()); }
};

/// Fits the distribution of `residuals` (N leads x samples, step-major). Only `regions` vary; the others' errors are
/// nil.
ResidualDistribution fit_residual_distribution(const Eigen::MatrixXd& residuals, int leads,
                                               const std::vector<int>& regions, const Bootstrap& bootstrap);

/// The set around a forecast: `mean` and `scale` are N x tau, tau at most leads(). Standard deviations are
/// floored at 0.1 (docs/model.md, section 5); where `scale` is 0 the count is certain, up to a tiny deviation that
/// keeps Sigma regular.
MomentSet moment_set(const ResidualDistribution& errors, const Eigen::MatrixXd& mean, const Eigen::MatrixXd& scale);

/// What the innovation test multiplies standard deviations by (N): the root of a region's normalised innovation, or of
/// the city's if that is more, where it exceeds the alarm; 1 elsewhere.
Eigen::VectorXd inflation(const ResidualDistribution& errors, const NormalisedInnovation& normalised_innovation);

/// Multiplies each region's standard deviations by `by` (N), in all steps.
void inflate(MomentSet& set, const Eigen::VectorXd& by);

}  // namespace evbal

#include "coordinator/ambiguity/covariance.hpp"

#include "common/contract.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

/// Weight of "no correlation" against the samples' correlations (Schaefer and Strimmer 2005, target D).
double shrinkage_intensity(const Eigen::MatrixXd& standardized, const Eigen::MatrixXd& correlation) {
  const auto n = static_cast<double>(standardized.cols());
  const Eigen::MatrixXd squared = standardized.cwiseAbs2();
  const Eigen::MatrixXd variance = (squared * squared.transpose() / n - correlation.cwiseAbs2()) / (n - 1.0);
  const double noise = variance.sum() - variance.trace();
  const double signal = correlation.squaredNorm() - correlation.diagonal().squaredNorm();
  return signal > 0.0 ? std::clamp(noise / signal, 0.0, 1.0) : 1.0;
}

/// Factors of a correlation matrix of d series and n samples: its eigenvalues above the Marchenko-Pastur edge, less
/// the mean of the others, after shrinkage by `intensity`.
Eigen::MatrixXd correlation_factors(const Eigen::MatrixXd& correlation, double intensity, Eigen::Index n) {
  const Eigen::Index d = correlation.rows();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(correlation);
  const double edge = std::pow(1.0 + std::sqrt(static_cast<double>(d) / static_cast<double>(n)), 2);
  const Eigen::Index rank = std::min<Eigen::Index>((eigen.eigenvalues().array() > edge).count(), d - 1);
  const Eigen::VectorXd shrunk = (1.0 - intensity) * eigen.eigenvalues().array() + intensity;
  const double noise = shrunk.head(d - rank).mean();
  const Eigen::VectorXd lengths = (shrunk.tail(rank).array() - noise).cwiseMax(0.0).sqrt();
  return eigen.eigenvectors().rightCols(rank) * lengths.asDiagonal();
}

}  // namespace

Eigen::MatrixXd Covariance::dense() const {
  Eigen::MatrixXd sigma = factors * factors.transpose();
  sigma.diagonal() += deviation.cwiseAbs2();
  return sigma;
}

Covariance shrunk_covariance(const Eigen::MatrixXd& residuals, double floor) {
  EVBAL_EXPECT(residuals.cols() >= 2 && residuals.rows() >= 1, "at least one series of two samples");
  const auto n = static_cast<double>(residuals.cols());
  const Eigen::VectorXd deviation = (residuals.rowwise().squaredNorm() / n).cwiseSqrt();
  const Eigen::MatrixXd standardized = deviation.cwiseMax(1e-12).cwiseInverse().asDiagonal() * residuals;
  const Eigen::MatrixXd correlation = standardized * standardized.transpose() / n;
  const double intensity = shrinkage_intensity(standardized, correlation);
  const Eigen::MatrixXd factors =
      deviation.asDiagonal() * correlation_factors(correlation, intensity, residuals.cols());
  const Eigen::VectorXd floored = deviation.cwiseMax(floor);
  const Eigen::VectorXd diagonal = floored.cwiseAbs2() - factors.rowwise().squaredNorm();
  return {diagonal.cwiseMax(0.01 * floor * floor).cwiseSqrt(), factors};
}

}  // namespace evbal

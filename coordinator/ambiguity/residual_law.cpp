#include "coordinator/ambiguity/residual_law.hpp"

#include "common/random.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace evbal {
namespace {

constexpr double deviation_floor = 0.1;      ///< vehicles, and scaled errors (model, section 5)
constexpr double certain_deviation = 0.001;  ///< vehicles

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

/// The statistics of one resample of whitened residuals.
Thresholds resampled(const Eigen::MatrixXd& whitened, RandomStream random, int resample) {
  Eigen::VectorXd times = Eigen::VectorXd::Zero(whitened.cols());
  for (int draw = 0; draw < resample; ++draw) {
    times(static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(whitened.cols())))) += 1.0;
  }
  times /= resample;
  const Eigen::MatrixXd weighted = whitened * times.cwiseSqrt().asDiagonal();
  const Eigen::MatrixXd second_moment = weighted * weighted.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(second_moment, Eigen::EigenvaluesOnly);
  return {(whitened * times).squaredNorm(), eigen.eigenvalues().maxCoeff()};
}

double order_statistic(std::vector<double> values, double alpha) {
  const auto size = static_cast<double>(values.size());
  const double rank = std::clamp(std::ceil(size * (1.0 - alpha)), 1.0, size);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// Rows of `regions` in each of `leads` blocks of `block` rows.
std::vector<Eigen::Index> rows_of(const std::vector<int>& regions, Eigen::Index block, int leads) {
  std::vector<Eigen::Index> rows;
  for (int lead = 0; lead < leads; ++lead) {
    for (const int region : regions) {
      rows.push_back(lead * block + region);
    }
  }
  return rows;
}

}  // namespace

Eigen::MatrixXd Covariance::dense() const {
  Eigen::MatrixXd sigma = factors * factors.transpose();
  sigma.diagonal() += deviation.cwiseAbs2();
  return sigma;
}

Covariance shrunk_covariance(const Eigen::MatrixXd& residuals, double floor) {
  assert(residuals.cols() >= 2 && residuals.rows() >= 1);
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

Thresholds bootstrap_thresholds(const Eigen::MatrixXd& residuals, const Covariance& covariance,
                                const Bootstrap& bootstrap) {
  assert(bootstrap.resample >= 1 && bootstrap.replicates >= 1);
  const Eigen::LLT<Eigen::MatrixXd> root(covariance.dense());
  assert(root.info() == Eigen::Success);
  const Eigen::MatrixXd whitened = root.matrixL().solve(residuals);
  std::vector<double> g1;
  std::vector<double> g2;
  for (int b = 0; b < bootstrap.replicates; ++b) {
    const StreamKey key{.region = 0, .tick = 0, .index = static_cast<std::uint64_t>(b)};
    const Thresholds one = resampled(whitened, {bootstrap.seed, Purpose::bootstrap, key}, bootstrap.resample);
    g1.push_back(one.g1);
    g2.push_back(one.g2);
  }
  return {order_statistic(std::move(g1), bootstrap.alpha), order_statistic(std::move(g2), bootstrap.alpha)};
}

ResidualLaw fit_residual_law(const Eigen::MatrixXd& residuals, int leads, const std::vector<int>& regions,
                             const Bootstrap& bootstrap) {
  assert(residuals.rows() % leads == 0);
  const Eigen::Index block = residuals.rows() / leads;
  ResidualLaw law{{Eigen::VectorXd::Zero(residuals.rows()), Eigen::MatrixXd(residuals.rows(), 0)}, {}};
  if (regions.empty()) {
    law.thresholds.assign(static_cast<std::size_t>(leads), {});
    return law;
  }
  const auto rows = rows_of(regions, block, leads);
  const Eigen::MatrixXd varying = residuals(rows, Eigen::all);
  const Covariance fitted = shrunk_covariance(varying, deviation_floor);
  for (int lead = 0; lead < leads; ++lead) {
    const auto head = static_cast<Eigen::Index>(regions.size()) * (lead + 1);
    const Covariance leading{fitted.deviation.head(head), fitted.factors.topRows(head)};
    law.thresholds.push_back(bootstrap_thresholds(varying.topRows(head), leading, bootstrap));
  }
  law.covariance.deviation(rows) = fitted.deviation;
  law.covariance.factors = Eigen::MatrixXd::Zero(residuals.rows(), fitted.factors.cols());
  law.covariance.factors(rows, Eigen::all) = fitted.factors;
  return law;
}

MomentSet moment_set(const ResidualLaw& law, const Eigen::MatrixXd& mean, const Eigen::MatrixXd& scale) {
  assert(mean.rows() == scale.rows() && mean.cols() == scale.cols());
  assert(mean.cols() >= 1 && mean.cols() <= law.leads());
  const Eigen::VectorXd by = scale.reshaped();
  const Thresholds& thresholds = law.thresholds[static_cast<std::size_t>(mean.cols() - 1)];
  MomentSet set;
  set.mean = mean.reshaped();
  set.factors = by.asDiagonal() * law.covariance.factors.topRows(by.size());
  const Eigen::VectorXd floors =
      (by.array() > 0.0).select(deviation_floor, Eigen::VectorXd::Constant(by.size(), certain_deviation));
  const Eigen::VectorXd diagonal = by.cwiseProduct(law.covariance.deviation.head(by.size()));
  const Eigen::VectorXd missing = floors.cwiseAbs2() - set.factors.rowwise().squaredNorm();
  set.deviation = diagonal.cwiseAbs2().cwiseMax(missing).cwiseMax(certain_deviation * certain_deviation).cwiseSqrt();
  set.g1 = thresholds.g1;
  set.g2 = thresholds.g2;
  return set;
}

}  // namespace evbal

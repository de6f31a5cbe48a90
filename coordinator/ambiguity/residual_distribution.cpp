#include "coordinator/ambiguity/residual_distribution.hpp"

#include "common/contract.hpp"

#include <cmath>

namespace evbal {
namespace {

constexpr double deviation_floor = 0.1;      ///< vehicles, and scaled errors (docs/model.md, section 5)
constexpr double certain_deviation = 0.001;  ///< vehicles

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

ResidualDistribution fit_residual_distribution(const Eigen::MatrixXd& residuals, int leads,
                                               const std::vector<int>& regions, const Bootstrap& bootstrap) {
  EVBAL_EXPECT(residuals.rows() % leads == 0, "as many residuals for each lead");
  const Eigen::Index block = residuals.rows() / leads;
  ResidualDistribution fit{{Eigen::VectorXd::Zero(residuals.rows()), Eigen::MatrixXd(residuals.rows(), 0)}, {}};
  if (regions.empty()) {
    fit.thresholds.assign(static_cast<std::size_t>(leads), {});
    return fit;
  }
  const auto rows = rows_of(regions, block, leads);
  const Eigen::MatrixXd varying = residuals(rows, Eigen::all);
  const Covariance fitted = shrunk_covariance(varying, deviation_floor);
  for (int lead = 0; lead < leads; ++lead) {
    const auto head = static_cast<Eigen::Index>(regions.size()) * (lead + 1);
    const Covariance leading{fitted.deviation.head(head), fitted.factors.topRows(head)};
    fit.thresholds.push_back(bootstrap_thresholds(varying.topRows(head), leading, bootstrap).value);
  }
  fit.covariance.deviation(rows) = fitted.deviation;
  fit.covariance.factors = Eigen::MatrixXd::Zero(residuals.rows(), fitted.factors.cols());
  fit.covariance.factors(rows, Eigen::all) = fitted.factors;
  return fit;
}

MomentSet moment_set(const ResidualDistribution& errors, const Eigen::MatrixXd& mean, const Eigen::MatrixXd& scale) {
  EVBAL_EXPECT(mean.rows() == scale.rows() && mean.cols() == scale.cols(), "mean and scale of one shape");
  EVBAL_EXPECT(mean.cols() >= 1 && mean.cols() <= errors.leads(), "from one step to as many as errors were fitted for");
  const Eigen::VectorXd by = scale.reshaped();
  const Thresholds& thresholds = errors.thresholds[static_cast<std::size_t>(mean.cols() - 1)];
  MomentSet set;
  set.mean = mean.reshaped();
  set.factors = by.asDiagonal() * errors.covariance.factors.topRows(by.size());
  const Eigen::VectorXd floors =
      (by.array() > 0.0).select(deviation_floor, Eigen::VectorXd::Constant(by.size(), certain_deviation));
  const Eigen::VectorXd diagonal = by.cwiseProduct(errors.covariance.deviation.head(by.size()));
  const Eigen::VectorXd missing = floors.cwiseAbs2() - set.factors.rowwise().squaredNorm();
  set.deviation = diagonal.cwiseAbs2().cwiseMax(missing).cwiseMax(certain_deviation * certain_deviation).cwiseSqrt();
  set.g1 = thresholds.g1;
  set.g2 = thresholds.g2;
  return set;
}

Eigen::VectorXd inflation(const ResidualDistribution& errors, const NormalisedInnovation& normalised_innovation) {
  const Eigen::ArrayXd squared = normalised_innovation.region.array().max(normalised_innovation.city);
  return (squared > errors.alarm).select(squared, 1.0).sqrt();
}

void inflate(MomentSet& set, const Eigen::VectorXd& by) {
  const Eigen::VectorXd each = by.replicate(set.mean.size() / by.size(), 1);
  set.deviation = set.deviation.cwiseProduct(each);
  set.factors = each.asDiagonal() * set.factors;
}

}  // namespace evbal

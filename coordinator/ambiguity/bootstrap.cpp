#include "coordinator/ambiguity/bootstrap.hpp"

#include "common/contract.hpp"
#include "common/parallel.hpp"
#include "common/random.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace evbal {
namespace {

/// Largest eigenvalue of a symmetric matrix, given by its lower triangle.
double largest_eigenvalue(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues().maxCoeff();
}

/// Residuals whose covariance is the identity, d x samples, and their inner products.
struct Whitened {
  Eigen::MatrixXd residuals;
  Eigen::MatrixXd gram;
};

/// Largest eigenvalue of sum_s times(s) w_s w_s'. It is that of the smaller one of two matrices: of the dimensions, and
/// of the inner products of the samples drawn.
double largest_moment(const Whitened& whitened, const Eigen::VectorXd& times) {
  const Eigen::Index d = whitened.residuals.rows();
  std::vector<Eigen::Index> drawn;
  for (Eigen::Index s = 0; s < times.size(); ++s) {
    if (times(s) > 0.0) {
      drawn.push_back(s);
    }
  }
  const Eigen::VectorXd weights = times.cwiseSqrt();
  if (static_cast<Eigen::Index>(drawn.size()) < d) {
    const Eigen::VectorXd of_drawn = weights(drawn);
    return largest_eigenvalue(of_drawn.asDiagonal() * whitened.gram(drawn, drawn) * of_drawn.asDiagonal());
  }
  Eigen::MatrixXd second_moment = Eigen::MatrixXd::Zero(d, d);
  second_moment.selfadjointView<Eigen::Lower>().rankUpdate(whitened.residuals * weights.asDiagonal());
  return largest_eigenvalue(second_moment);
}

/// The statistics of one resample.
Thresholds resampled(const Whitened& whitened, RandomStream random, int resample) {
  const Eigen::Index samples = whitened.residuals.cols();
  Eigen::VectorXd times = Eigen::VectorXd::Zero(samples);
  for (int draw = 0; draw < resample; ++draw) {
    times(static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(samples)))) += 1.0;
  }
  times /= resample;
  return {(whitened.residuals * times).squaredNorm(), largest_moment(whitened, times)};
}

/// The statistics of every replicate.
std::vector<Thresholds> replicates(const Eigen::MatrixXd& residuals, const Covariance& covariance,
                                   const Bootstrap& bootstrap) {
  EVBAL_EXPECT(bootstrap.resample >= 1 && bootstrap.replicates >= 1, "at least one replicate of one residual");
  const Eigen::LLT<Eigen::MatrixXd> root(covariance.dense());
  EVBAL_EXPECT(root.info() == Eigen::Success, "a positive definite covariance");
  Whitened whitened{root.matrixL().solve(residuals), {}};
  whitened.gram = whitened.residuals.transpose() * whitened.residuals;
  std::vector<Thresholds> out(static_cast<std::size_t>(bootstrap.replicates));
  parallel_for(out.size(), [&](std::size_t b) {
    out[b] = resampled(whitened, {bootstrap.seed, Purpose::bootstrap, {.index = b}}, bootstrap.resample);
  });
  return out;
}

struct OrderStatistic {
  double value = 0.0;
  double error = 0.0;
};

/// The order statistic, and half the distance between those that lie as many ranks around it as the rank of the true
/// quantile varies by (one binomial standard deviation).
OrderStatistic order_statistic(std::vector<double> values, double alpha) {
  std::sort(values.begin(), values.end());
  const auto size = static_cast<double>(values.size());
  const double rank = std::ceil(size * (1.0 - alpha));
  const double spread = std::sqrt(size * alpha * (1.0 - alpha));
  const auto at = [&](double r) { return values[static_cast<std::size_t>(std::clamp(r, 1.0, size)) - 1]; };
  return {at(rank), (at(rank + spread) - at(rank - spread)) / 2.0};
}

}  // namespace

BootstrapThresholds bootstrap_thresholds(const Eigen::MatrixXd& residuals, const Covariance& covariance,
                                         const Bootstrap& bootstrap) {
  std::vector<double> g1;
  std::vector<double> g2;
  for (const Thresholds& one : replicates(residuals, covariance, bootstrap)) {
    g1.push_back(one.g1);
    g2.push_back(one.g2);
  }
  const OrderStatistic first = order_statistic(std::move(g1), bootstrap.alpha);
  const OrderStatistic second = order_statistic(std::move(g2), bootstrap.alpha);
  return {{first.value, second.value}, {first.error, second.error}};
}

Coverage coverage(const Eigen::MatrixXd& residuals, const Covariance& covariance, const Thresholds& thresholds,
                  const Bootstrap& bootstrap) {
  Coverage share;
  const double each = 1.0 / bootstrap.replicates;
  for (const Thresholds& one : replicates(residuals, covariance, bootstrap)) {
    const bool mean = one.g1 <= thresholds.g1;
    const bool moment = one.g2 <= thresholds.g2;
    share.g1 += mean ? each : 0.0;
    share.g2 += moment ? each : 0.0;
    share.both += mean && moment ? each : 0.0;
  }
  return share;
}

}  // namespace evbal

#include "coordinator/ambiguity/residual_law.hpp"

#include "common/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

Eigen::MatrixXd normals(Eigen::Index rows, Eigen::Index cols, std::uint64_t seed) {
  RandomStream random(seed, Purpose::bootstrap, {.region = 99});
  return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return random.normal(); });
}

Covariance identity(Eigen::Index d) {
  return {Eigen::VectorXd::Ones(d), Eigen::MatrixXd(d, 0)};
}

TEST(ShrunkCovariance, FindsTheCommonFactor) {
  const Eigen::VectorXd loading = Eigen::VectorXd::LinSpaced(20, 0.5, 2.0);
  const Eigen::MatrixXd residuals = normals(20, 2000, 1) + loading * normals(1, 2000, 2);
  const Eigen::MatrixXd truth = Eigen::MatrixXd(loading * loading.transpose()) + Eigen::MatrixXd::Identity(20, 20);
  const Covariance fitted = shrunk_covariance(residuals, 0.1);
  EXPECT_EQ(fitted.factors.cols(), 1);
  EXPECT_LT((fitted.dense() - truth).norm() / truth.norm(), 0.1);
}

TEST(ShrunkCovariance, UnrelatedSeriesStayUnrelatedThoughSamplesAreFew) {
  const Eigen::MatrixXd residuals = normals(60, 30, 3);
  const Covariance fitted = shrunk_covariance(residuals, 0.1);
  EXPECT_LT((fitted.dense() - Eigen::MatrixXd::Identity(60, 60)).norm() / std::sqrt(60.0), 0.6);
  EXPECT_GT(fitted.deviation.minCoeff(), 0.0);
}

TEST(ShrunkCovariance, KeepsVariancesAndFloorsThem) {
  Eigen::MatrixXd residuals = normals(4, 500, 4);
  residuals.row(2).setZero();
  const Eigen::VectorXd variance = shrunk_covariance(residuals, 0.1).dense().diagonal();
  const Eigen::VectorXd sample = residuals.rowwise().squaredNorm() / 500.0;
  EXPECT_NEAR(variance(0), sample(0), 1e-12);
  EXPECT_NEAR(variance(2), 0.01, 1e-12);
}

TEST(BootstrapThresholds, AgreeWithGaussianTheory) {
  // d = 10: N_B g1 is chi-squared with 10 degrees of freedom, whose .75 quantile is 12.549; g2 by simulation (model,
  // section 5).
  const Eigen::MatrixXd residuals = normals(10, 4000, 5);
  const Covariance sigma = shrunk_covariance(residuals, 0.1);
  const Thresholds at50 = bootstrap_thresholds(residuals, sigma, {.resample = 50, .replicates = 1000});
  EXPECT_NEAR(at50.g1, 12.549 / 50.0, 0.015);
  EXPECT_NEAR(at50.g2, 1.98, 0.05);
  const Thresholds at500 = bootstrap_thresholds(residuals, sigma, {.resample = 500, .replicates = 1000});
  EXPECT_LT(at500.g1, at50.g1);
  EXPECT_NEAR(at500.g2, 1.28, 0.03);
}

TEST(BootstrapThresholds, DoNotDependOnUnits) {
  const Eigen::MatrixXd residuals = normals(5, 200, 6);
  const Covariance sigma = shrunk_covariance(residuals, 0.001);
  const Bootstrap few{.resample = 100, .replicates = 50};
  const Thresholds one = bootstrap_thresholds(residuals, sigma, few);
  const Thresholds ten = bootstrap_thresholds(10.0 * residuals, {10.0 * sigma.deviation, 10.0 * sigma.factors}, few);
  EXPECT_NEAR(one.g1, ten.g1, 1e-12);
  EXPECT_NEAR(one.g2, ten.g2, 1e-9);
}

TEST(BootstrapThresholds, TakeTheOrderStatisticOfTheModel) {
  // One sample: every resample is that sample.
  const Eigen::MatrixXd residuals = Eigen::MatrixXd::Constant(1, 1, 3.0);
  const Thresholds only = bootstrap_thresholds(residuals, identity(1), {.resample = 7, .replicates = 4});
  EXPECT_NEAR(only.g1, 9.0, 1e-12);
  EXPECT_NEAR(only.g2, 9.0, 1e-12);
}

TEST(ResidualLaw, LeavesOtherRegionsCertain) {
  const Eigen::MatrixXd residuals = normals(6, 300, 7);
  const ResidualLaw law = fit_residual_law(residuals, 2, {0, 2}, {.resample = 50, .replicates = 20});
  ASSERT_EQ(law.leads(), 2);
  Eigen::MatrixXd scale(3, 2);
  scale << 2.0, 2.0, 0.0, 0.0, 0.01, 0.01;
  const MomentSet set = moment_set(law, Eigen::MatrixXd::Ones(3, 2), scale);
  const Eigen::VectorXd sd = set.standard_deviation();
  EXPECT_NEAR(sd(0), 2.0, 0.3);
  EXPECT_LT(sd(1), 0.01);
  EXPECT_GT(set.deviation.minCoeff(), 0.0);
  EXPECT_NEAR(sd(2), 0.1, 1e-9) << "floored";
  EXPECT_EQ(set.g1, law.thresholds[1].g1);
  const MomentSet last = moment_set(law, Eigen::MatrixXd::Ones(3, 1), scale.leftCols(1));
  EXPECT_EQ(last.mean.size(), 3);
  EXPECT_EQ(last.g1, law.thresholds[0].g1);
}

}  // namespace
}  // namespace evbal

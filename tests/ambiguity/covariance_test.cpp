#include "coordinator/ambiguity/covariance.hpp"

#include "tests/ambiguity/normals.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

using testing::normals;

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

}  // namespace
}  // namespace evbal

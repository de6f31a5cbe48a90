#include "coordinator/ambiguity/residual_distribution.hpp"

#include "tests/ambiguity/normals.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

using testing::normals;

TEST(ResidualDistribution, LeavesOtherRegionsCertain) {
  const Eigen::MatrixXd residuals = normals(6, 300, 7);
  const ResidualDistribution errors =
      fit_residual_distribution(residuals, 2, {0, 2}, {.resample = 50, .replicates = 20});
  ASSERT_EQ(errors.leads(), 2);
  Eigen::MatrixXd scale(3, 2);
  scale << 2.0, 2.0, 0.0, 0.0, 0.01, 0.01;
  const MomentSet set = moment_set(errors, Eigen::MatrixXd::Ones(3, 2), scale);
  const Eigen::VectorXd sd = set.standard_deviation();
  EXPECT_NEAR(sd(0), 2.0, 0.3);
  EXPECT_LT(sd(1), 0.01);
  EXPECT_GT(set.deviation.minCoeff(), 0.0);
  EXPECT_NEAR(sd(2), 0.1, 1e-9) << "floored";
  EXPECT_EQ(set.g1, errors.thresholds[1].g1);
  const MomentSet last = moment_set(errors, Eigen::MatrixXd::Ones(3, 1), scale.leftCols(1));
  EXPECT_EQ(last.mean.size(), 3);
  EXPECT_EQ(last.g1, errors.thresholds[0].g1);
}

TEST(Inflation, IsTheRootOfWhatExceedsTheAlarm) {
  ResidualDistribution errors;
  errors.alarm = 4.0;
  EXPECT_EQ(inflation(errors, {.city = 4.0, .region = Eigen::Vector3d(0.0, 4.0, 9.0)}), Eigen::Vector3d(1.0, 1.0, 3.0));
  EXPECT_EQ(inflation(errors, {.city = 6.25, .region = Eigen::Vector3d(0.0, 4.0, 9.0)}),
            Eigen::Vector3d(2.5, 2.5, 3.0));
}

TEST(Inflation, MultipliesStandardDeviationsInAllSteps) {
  const ResidualDistribution errors =
      fit_residual_distribution(normals(4, 300, 7), 2, {0, 1}, {.resample = 50, .replicates = 20});
  MomentSet set = moment_set(errors, Eigen::MatrixXd::Ones(2, 2), Eigen::MatrixXd::Ones(2, 2));
  const Eigen::VectorXd before = set.standard_deviation();
  inflate(set, Eigen::Vector2d(1.0, 3.0));
  EXPECT_TRUE(set.standard_deviation().isApprox(before.cwiseProduct(Eigen::Vector4d(1.0, 3.0, 1.0, 3.0))));
}

}  // namespace
}  // namespace evbal

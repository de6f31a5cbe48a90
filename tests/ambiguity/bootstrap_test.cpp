#include "coordinator/ambiguity/bootstrap.hpp"

#include "tests/ambiguity/normals.hpp"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

using testing::normals;

Covariance identity(Eigen::Index d) {
  return {Eigen::VectorXd::Ones(d), Eigen::MatrixXd(d, 0)};
}

TEST(BootstrapThresholds, AgreeWithGaussianTheory) {
  // d = 10: N_B g1 is chi-squared with 10 degrees of freedom, whose .75 quantile is 12.549; g2 by simulation (model,
  // section 5).
  const Eigen::MatrixXd residuals = normals(10, 4000, 5);
  const Covariance sigma = shrunk_covariance(residuals, 0.1);
  const Thresholds at50 = bootstrap_thresholds(residuals, sigma, {.resample = 50}).value;
  EXPECT_NEAR(at50.g1, 12.549 / 50.0, 0.015);
  EXPECT_NEAR(at50.g2, 1.98, 0.05);
  const Thresholds at500 = bootstrap_thresholds(residuals, sigma, {.resample = 500}).value;
  EXPECT_LT(at500.g1, at50.g1);
  EXPECT_NEAR(at500.g2, 1.28, 0.03);
}

TEST(BootstrapThresholds, DoNotDependOnUnits) {
  const Eigen::MatrixXd residuals = normals(5, 200, 6);
  const Covariance sigma = shrunk_covariance(residuals, 0.001);
  const Bootstrap few{.resample = 100, .replicates = 50};
  const Thresholds one = bootstrap_thresholds(residuals, sigma, few).value;
  const Thresholds ten =
      bootstrap_thresholds(10.0 * residuals, {10.0 * sigma.deviation, 10.0 * sigma.factors}, few).value;
  EXPECT_NEAR(one.g1, ten.g1, 1e-12);
  EXPECT_NEAR(one.g2, ten.g2, 1e-9);
}

TEST(BootstrapThresholds, TakeTheOrderStatisticOfTheModel) {
  // One sample: every resample is that sample.
  const Eigen::MatrixXd residuals = Eigen::MatrixXd::Constant(1, 1, 3.0);
  const Thresholds only = bootstrap_thresholds(residuals, identity(1), {.resample = 7, .replicates = 4}).value;
  EXPECT_NEAR(only.g1, 9.0, 1e-12);
  EXPECT_NEAR(only.g2, 9.0, 1e-12);
}

TEST(BootstrapThresholds, AreThoseOfTheSamplesPlaneWhereDimensionsAreMore) {
  // Samples in a plane, seen from two dimensions, where a resample has more samples, and from thirty.
  const Eigen::MatrixXd plane = normals(2, 40, 11);
  const Eigen::MatrixXd axes = normals(30, 2, 12).householderQr().householderQ() * Eigen::MatrixXd::Identity(30, 2);
  const Bootstrap few{.resample = 20, .replicates = 30};
  const Thresholds two = bootstrap_thresholds(plane, identity(2), few).value;
  const Thresholds thirty = bootstrap_thresholds(axes * plane, identity(30), few).value;
  EXPECT_NEAR(thirty.g1, two.g1, 1e-12);
  EXPECT_NEAR(thirty.g2, two.g2, 1e-12);
}

TEST(BootstrapThresholds, KnowTheirErrorOfDrawing) {
  const Eigen::MatrixXd residuals = normals(3, 100, 8);
  const Covariance sigma = shrunk_covariance(residuals, 0.1);
  const int seeds = 60;
  Eigen::VectorXd g1(seeds);
  Eigen::VectorXd g2(seeds);
  Thresholds error{.g1 = 0.0, .g2 = 0.0};
  for (int seed = 0; seed < seeds; ++seed) {
    const Bootstrap few{.resample = 30, .replicates = 100, .seed = static_cast<std::uint64_t>(seed)};
    const BootstrapThresholds one = bootstrap_thresholds(residuals, sigma, few);
    g1(seed) = one.value.g1;
    g2(seed) = one.value.g2;
    error.g1 += one.error.g1 / seeds;
    error.g2 += one.error.g2 / seeds;
  }
  const auto spread = [](const Eigen::VectorXd& x) { return std::sqrt((x.array() - x.mean()).square().mean()); };
  EXPECT_NEAR(error.g1, spread(g1), 0.4 * spread(g1));
  EXPECT_NEAR(error.g2, spread(g2), 0.4 * spread(g2));
}

TEST(Coverage, IsAsPromisedOnResidualsOfTheSameLaw) {
  const Eigen::MatrixXd residuals = normals(6, 1000, 9);
  const Eigen::MatrixXd others = normals(6, 1000, 10);
  const Covariance sigma = identity(6);
  const Bootstrap bootstrap{.resample = 50};
  const Thresholds thresholds = bootstrap_thresholds(residuals, sigma, bootstrap).value;
  const Coverage same = coverage(residuals, sigma, thresholds, bootstrap);
  EXPECT_NEAR(same.g1, 0.75, 1e-9) << "the same draws";
  EXPECT_NEAR(same.g2, 0.75, 1e-9);
  EXPECT_LE(same.both, 0.75);
  EXPECT_NEAR(coverage(others, sigma, thresholds, bootstrap).g1, 0.75, 0.15);
  EXPECT_LT(coverage(2.0 * others, sigma, thresholds, bootstrap).g2, 0.01) << "twice as far off as promised";
  const Eigen::MatrixXd biased = others.array() + 0.5;
  EXPECT_LT(coverage(biased, sigma, thresholds, bootstrap).g1, 0.1);
}

}  // namespace
}  // namespace evbal

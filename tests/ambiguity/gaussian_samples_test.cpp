#include "coordinator/ambiguity/gaussian_samples.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(GaussianSamples, HaveTheSetsMoments) {
  MomentSet set;
  set.mean = Eigen::Vector3d(1.0, -2.0, 5.0);
  set.deviation = Eigen::Vector3d(0.5, 1.0, 0.1);
  set.factors = (Eigen::MatrixXd(3, 1) << 1.0, -1.0, 0.0).finished();
  const int count = 20000;
  const Eigen::MatrixXd centred = gaussian_samples(set, count).colwise() - set.mean;
  EXPECT_LT(centred.rowwise().mean().cwiseAbs().maxCoeff(), 0.04);
  Eigen::Matrix3d sigma = set.factors * set.factors.transpose();
  sigma.diagonal() += set.deviation.cwiseAbs2();
  EXPECT_LT((centred * centred.transpose() / count - sigma).cwiseAbs().maxCoeff(), 0.05);
}

TEST(GaussianSamples, SeeTheSameLuckEachTime) {
  MomentSet set;
  set.mean = Eigen::Vector2d(1.0, 2.0);
  set.deviation = Eigen::Vector2d(1.0, 1.0);
  set.factors = Eigen::MatrixXd(2, 0);
  const Eigen::MatrixXd before = gaussian_samples(set, 5);
  set.mean.array() += 3.0;
  EXPECT_TRUE(gaussian_samples(set, 5).isApprox((before.array() + 3.0).matrix()));
}

}  // namespace
}  // namespace evbal

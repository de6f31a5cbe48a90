#include "coordinator/ambiguity/gaussian_samples.hpp"

#include "common/random.hpp"

namespace evbal {

Eigen::MatrixXd gaussian_samples(const MomentSet& set, int count) {
  Eigen::MatrixXd samples(set.mean.size(), count);
  for (Eigen::Index s = 0; s < count; ++s) {
    RandomStream random(0, Purpose::demand_sample, {.index = static_cast<std::uint64_t>(s)});
    const auto normals = [&random](Eigen::Index size) -> Eigen::VectorXd {
      return Eigen::VectorXd::NullaryExpr(size, [&random] { return random.normal(); });
    };
    const Eigen::VectorXd common = normals(set.factors.cols());
    samples.col(s) = set.mean + set.factors * common + set.deviation.cwiseProduct(normals(set.mean.size()));
  }
  return samples;
}

}  // namespace evbal

#pragma once

#include "common/eigen.hpp"
#include "coordinator/ambiguity/moment_set.hpp"

namespace evbal {

/// `count` draws of the Gaussian with the set's mean and covariance, one a column. The underlying normals depend on the
/// sizes only, so that plans in a row see the same luck.
Eigen::MatrixXd gaussian_samples(const MomentSet& set, int count);

}  // namespace evbal

#pragma once

#include "common/random.hpp"

#include <Eigen/Core>

namespace evbal::testing {

/// Independent standard normals.
inline Eigen::MatrixXd normals(Eigen::Index rows, Eigen::Index cols, std::uint64_t seed) {
  RandomStream random(seed, Purpose::bootstrap, {.region = 99});
  return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return random.normal(); });
}

}  // namespace evbal::testing

#include "tools/ingest/regions_by_distance.hpp"

#include "agents/world/geometry.hpp"
#include "tools/ingest/rounding.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

constexpr double kAlone = 1.0;     // km from the centre to the side of a region without neighbours
constexpr double kSmallest = 0.1;  // km likewise

/// N x 2, km.
Eigen::MatrixXd scaled(const Eigen::MatrixXd& km) {
  const Eigen::Index n = km.rows();
  Eigen::MatrixXd squares = (0.5 * (km + km.transpose())).array().square();
  squares.diagonal().setZero();
  const Eigen::MatrixXd centring =
      Eigen::MatrixXd::Identity(n, n) - Eigen::MatrixXd::Constant(n, n, 1.0 / static_cast<double>(n));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(-0.5 * centring * squares * centring);
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(n, 2);
  for (Eigen::Index axis = 0; axis < std::min<Eigen::Index>(n, 2); ++axis) {
    const Eigen::Index at = n - 1 - axis;  // eigenvalues ascend
    Eigen::VectorXd along = axes.eigenvectors().col(at);
    Eigen::Index farthest = 0;
    along.cwiseAbs().maxCoeff(&farthest);
    along *= along[farthest] < 0.0 ? -1.0 : 1.0;  // the sign of an eigenvector is arbitrary
    places.col(axis) = std::sqrt(std::max(0.0, axes.eigenvalues()[at])) * along;
  }
  return places;
}

double half_side(const Eigen::MatrixXd& places, Eigen::Index i) {
  double nearest = 4.0 * kAlone;
  for (Eigen::Index j = 0; j < places.rows(); ++j) {
    nearest = j == i ? nearest : std::min(nearest, (places.row(i) - places.row(j)).norm());
  }
  return std::max(kSmallest, nearest / 4.0);
}

}  // namespace

std::vector<Region> regions_by_distance(const Eigen::MatrixXd& km) {
  const Eigen::MatrixXd places = scaled(km);
  const LocalFrame frame({0.0, 0.0});
  std::vector<Region> regions;
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    const double half = half_side(places, i);
    const auto corner = [&](double east, double north) {
      return rounded(frame.global({1000.0 * (places(i, 0) + east * half), 1000.0 * (places(i, 1) + north * half)}));
    };
    regions.push_back(
        {"r" + std::to_string(i), {{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}}, corner(0, 0)});
  }
  return regions;
}

}  // namespace evbal

#pragma once

#include "common/eigen.hpp"

#include <vector>

namespace evbal {

/// A station that is placed in a region.
struct StationChoice {
  int region = 0;  ///< where it stands
  int points = 0;  ///< its charging points
};

/// Places `stations` in different regions, one after the other where it shortens most the way to the nearest station,
/// summed over regions by `demand`; then shares `points` (>= stations) by the demand that each is nearest to, one at
/// least. By region. Deterministic.
std::vector<StationChoice> choose_stations(const Eigen::MatrixXd& km, const Eigen::VectorXd& demand, int stations,
                                           int points);

}  // namespace evbal

#pragma once

#include "coordinator/balancing/problem.hpp"

#include <cstdint>

namespace evbal {

/// Size and mean values of a random city.
struct DataShape {
  /// N.
  int regions = 5;
  int tau = 2;                        ///< steps
  int rank = 2;                       ///< of the covariances' factors
  double vehicles_per_region = 10.0;  ///< vacant
  double demand_scale = 1.0;          ///< on the expected passengers
  double station_share = 0.4;         ///< of the regions; the first always has one, unless this is 0
  double chargeable_share = 0.0;      ///< of the vacant cars
  int out_degree = 0;                 ///< cars reach a region itself and so many nearest in a step; 0: every region
};

/// A random city at a random moment, which validate() accepts; the same for the same seed and shape.
PlanningData random_planning_data(std::uint64_t seed, const DataShape& shape);

}  // namespace evbal

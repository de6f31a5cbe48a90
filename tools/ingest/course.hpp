#pragma once

#include "agents/world/city.hpp"
#include "common/eigen.hpp"

#include <vector>

namespace evbal {

/// How a city's demand goes over its days.
struct Course {
  Eigen::MatrixXd share;          ///< days x steps: trips that start then, over those of a mean day
  double region_deviation = 0.0;  ///< of a region's pick-ups on a weekday, relative, beyond what chance would do
};

/// Measured on `days`, all of a city's days with `regions` regions, in order: of its trips by day and step, and of its
/// pick-ups by region and weekday around the region's share of the day's trips. A city without trips has all zeros.
Course course_of(const std::vector<DemandDay>& days, int regions);

}  // namespace evbal

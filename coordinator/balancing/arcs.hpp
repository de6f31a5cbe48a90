#pragma once

#include "common/eigen.hpp"

#include <vector>

namespace evbal {

/// A pair of regions between which vehicles may be sent.
struct Arc {
  int from = 0;     ///< region
  int to = 0;       ///< region
  double km = 0.0;  ///< of the way
};

/// Arcs for vacant cars, by (from, to): to regions nearer than `max_km`, at most `neighbours` nearest of them, and,
/// whatever these say, to and from the nearest region. Nearest by km, ties by index; where km is infinite there is
/// no road and no arc.
std::vector<Arc> vacant_arcs(const Eigen::MatrixXd& km, double max_km, int neighbours);

/// Arcs for low-battery cars, by (from, to): likewise, but only to regions with `station`, and always to the nearest
/// of these.
std::vector<Arc> low_battery_arcs(const Eigen::MatrixXd& km, const std::vector<bool>& station, double max_km,
                                  int neighbours);

}  // namespace evbal

#pragma once

#include <optional>
#include <vector>

namespace evbal {

/// What one setting of a controller came to on one day.
struct FrontPoint {
  double cost = 0.0;   ///< such as idle km
  double value = 0.0;  ///< such as lost passengers
};

/// The value that a controller has at `cost`, linear between the neighbouring points of its front, in any order; of
/// points with the same cost the lowest counts. Nothing if `cost` lies outside of the front: it says nothing there.
std::optional<double> value_at(std::vector<FrontPoint> front, double cost);

/// The lower convex hull of the points that no other one betters in cost and value, by cost: what a controller comes to
/// if it changes between its settings. One point at least, costs rising and values falling.
std::vector<FrontPoint> lower_hull(std::vector<FrontPoint> front);

/// The least that several days come to together for each cost in all, from the lower hull of each, of which there is
/// one at least: where the next cost saves most, it is spent first.
std::vector<FrontPoint> least_sum(const std::vector<std::vector<FrontPoint>>& hulls);

}  // namespace evbal

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace evbal {

/// What one setting of a controller came to on one day.
struct FrontPoint {
  double cost = 0.0;   ///< such as idle km
  double value = 0.0;  ///< such as lost passengers
};

/// The value at `cost` of the line through points of rising cost. Nothing if `cost` lies outside: they say nothing
/// there.
std::optional<double> value_at(const std::vector<FrontPoint>& front, double cost);

/// The positions of the corners of the lower convex hull, by cost, among points in any order: those that no other one,
/// and no line between two others, betters in cost and value. Costs rise and values fall from corner to corner.
std::vector<std::size_t> hull_corners(const std::vector<FrontPoint>& points);

/// These corners themselves: what a controller comes to if it changes between its settings.
std::vector<FrontPoint> lower_hull(const std::vector<FrontPoint>& points);

/// The least that several days come to together for each cost in all, from the lower hull of each, of which there is
/// one at least: where the next cost saves most, it is spent first.
std::vector<FrontPoint> least_sum(const std::vector<std::vector<FrontPoint>>& hulls);

}  // namespace evbal

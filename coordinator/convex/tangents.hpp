#pragma once

#include "coordinator/convex/convex_function.hpp"

#include <cstddef>
#include <vector>

namespace evbal {

/// A convex function from below: the largest of its tangents at some points, straight piece by piece from a lower end
/// on.
class Tangents {
 public:
  /// The piece of one tangent.
  struct Piece {
    double at = 0.0;     ///< where it touches
    double slope = 0.0;  ///< rises from piece to piece
    double width = 0.0;  ///< of the last: infinite
  };

  /// Starts with tangents ever further apart from `lower` on.
  Tangents(ConvexFunctionPtr function, double lower);

  /// Adds the tangent at a point of at least `lower`, unless there is one.
  void add(double at);

  /// Adds tangents between those that enclose a slope, and in the gaps on both sides.
  void add_around(double slope);

  double value_at_lower() const;
  std::vector<Piece> pieces() const;

 private:
  struct Tangent {
    double at = 0.0;
    double value = 0.0;
    double slope = 0.0;
  };

  ConvexFunctionPtr function_;
  double lower_;
  std::vector<Tangent> tangents_;  // ascending
};

}  // namespace evbal

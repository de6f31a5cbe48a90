#pragma once

#include "coordinator/convex/convex_function.hpp"

#include <cstddef>
#include <vector>

namespace evbal {

/// A convex function from below: the largest of its tangents at some points of [lower, upper], beyond which nobody asks
/// for the function. Straight piece by piece from `lower` on.
class Tangents {
 public:
  /// The piece of one tangent.
  struct Piece {
    double at = 0.0;     ///< where it touches
    double slope = 0.0;  ///< rises from piece to piece
    double width = 0.0;  ///< of the last: infinite
  };

  /// Starts with tangents ever further apart from `lower` on; `upper` may be infinite.
  Tangents(ConvexFunctionPtr function, double lower, double upper);

  /// Adds the tangent at a point of [lower, upper], unless there is one.
  void add(double at);

  /// Adds tangents between those that enclose a slope, and in the gaps on both sides; none for a slope of -infinity.
  void add_around(double slope);

  /// The function at the lower bound.
  double value_at_lower() const;
  /// The linear pieces, from the lower bound on.
  std::vector<Piece> pieces() const;

 private:
  struct Tangent {
    double at = 0.0;
    double value = 0.0;
    double slope = 0.0;
  };

  ConvexFunctionPtr function_;
  double lower_;
  double upper_;
  std::vector<Tangent> tangents_;  // ascending
};

}  // namespace evbal

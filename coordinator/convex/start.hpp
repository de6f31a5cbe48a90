#pragma once

#include "coordinator/convex/expression.hpp"

#include <cstdint>
#include <vector>

namespace evbal {

/// Stands for the name of a variable or a row: equal names have equal keys.
std::uint64_t key_of(const Name& name);

/// What the tangents of a curve were at an optimum.
struct CurveStart {
  std::uint64_t above = 0;    ///< key of the variable above the curve
  double at = 0.0;            ///< the argument
  double slope = 0.0;         ///< that prices asked of the curve; -infinity if none
  std::vector<double> basic;  ///< where the tangents touch whose pieces were basic
};

/// Where a solve ended, from where that of a similar program may start: the basis of a simplex method, by keys of
/// names, as numbers that a journal can hold. What it does not know of is at its lower bound, or a row that does not
/// bind. Any start leads to the same optimum.
struct Start {
  std::vector<std::uint64_t> basic;     ///< variables in the basis, ascending
  std::vector<std::uint64_t> at_upper;  ///< variables at their upper bound, ascending
  std::vector<std::uint64_t> binding;   ///< rows that hold as equations, ascending
  std::vector<CurveStart> curves;       ///< by `above`, ascending

  /// Whether nothing is known.
  bool empty() const { return !has_basis() && curves.empty(); }

  /// Whether more is known than the curves.
  bool has_basis() const { return !basic.empty() || !at_upper.empty() || !binding.empty(); }

  /// What is known of the curve below the variable of this key; null if nothing is.
  const CurveStart* of_curve(std::uint64_t above) const;
};

}  // namespace evbal

#pragma once

#include "coordinator/convex/engine.hpp"

namespace evbal {

/// Cutting planes: linear programs (COIN-OR Clp) whose optima rise to the program's from below, each with more tangents
/// than the last. Lifted onto its curves, every such optimum is also a point of the program, so the method stops on a
/// certified gap. One iteration is one linear program, solved from the prices of the last; a plan takes about three.
///
/// Tangents stay valid while their curve is the same, so plan after plan could share them. Each starts afresh all the
/// same: the first of the three takes nearly all the time, from whatever tangents. Started with those around the last
/// plan's optimum, the plans of the San Francisco day took 310 to 324 linear programs in place of 321, and up to a
/// third more time, for more columns. So a plan depends on nothing but its own data, in a replay too.
Solution solve_with_cuts(const ConvexProgram& program, const EngineSettings& settings);

}  // namespace evbal

#pragma once

#include "coordinator/balancing/engine.hpp"

namespace evbal {

/// Cutting planes: linear programs (COIN-OR Clp) whose optima rise to the program's from below, each with more tangents
/// than the last. Lifted onto its curves, every such optimum is also a point of the program, so the method stops on a
/// certified gap. One iteration is one linear program, solved by the dual simplex method from the basis of the last.
///
/// Tangents of a curve stay valid while the curve is the same, so plan after plan could share them. Each starts afresh
/// all the same: the first tangents are not what costs, and a plan depends on nothing but its own data, in a replay
/// too.
Solution solve_with_cuts(const ConvexProgram& program, const EngineSettings& settings);

}  // namespace evbal

#pragma once

#include "coordinator/convex/engine.hpp"

namespace evbal {

/// Cutting planes: linear programs (COIN-OR Clp) whose optima rise to the program's from below, each with more tangents
/// than the last. Lifted onto its curves, every such optimum is also a point of the program, so the method stops on a
/// certified gap. One iteration is one linear program, solved from the prices of the last; a plan takes about three.
///
/// Every solve starts afresh, so that a plan depends on nothing but its own data, in a replay too. Nothing is lost by
/// that: the first linear program takes nearly all the time whatever tangents it starts with, and tangents kept from
/// the last plan only add columns.
Solution solve_with_cuts(const ConvexProgram& program, const EngineSettings& settings);

}  // namespace evbal

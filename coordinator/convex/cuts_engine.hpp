#pragma once

#include "coordinator/convex/engine.hpp"

namespace evbal {

/// Cutting planes: linear programs (COIN-OR Clp) whose optima rise to the program's from below, each with more tangents
/// than the last. Lifted onto its curves, every such optimum is also a point of the program, so the method stops on a
/// certified gap. One iteration is one linear program, solved from the prices of the last; a plan takes about three.
///
/// The first linear program takes nearly all the time, and less if it starts where the solve of a similar program
/// ended. That is a value, and there is no other state: the same program and start have the same solution, in a replay
/// too.
Solution solve_with_cuts(const ConvexProgram& program, const EngineSettings& settings, const Start& start = {});

}  // namespace evbal

#pragma once

#include "coordinator/balancing/engine.hpp"

namespace evbal {

/// Cutting planes: linear programs (COIN-OR Clp) whose optima rise to the program's from below, each with more tangents
/// than the last. Lifted onto its curves, every such optimum is also a point of the program, so the method stops on a
/// certified gap. One iteration is one linear program, solved from the prices of the last.
Solution solve_with_cuts(const ConvexProgram& program, const EngineSettings& settings);

}  // namespace evbal

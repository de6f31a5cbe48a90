#pragma once

#include "coordinator/convex/engine.hpp"

#include <string>

namespace evbal {

/// Interior-point method (Ipopt with MUMPS) on the smooth program. Its lower bound is the optimum of one linear
/// program: the tangents at the point where it stopped.
Solution solve_with_ipopt(const ConvexProgram& program, const EngineSettings& settings);

/// "3.14.17"
std::string ipopt_version();

}  // namespace evbal

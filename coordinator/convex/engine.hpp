#pragma once

#include "coordinator/convex/certificate.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace evbal {

/// Which engine solves, and how much work it may spend. Never a wall clock: results must not depend on the machine's
/// speed.
struct EngineSettings {
  std::string name = "ipopt";
  int max_iterations = 300;  ///< of the engine's own kind: Newton steps of `ipopt`, linear programs of `cuts`
  bool fails = false;        ///< whatever is to be solved, as a fault will have it
};

struct Solution {
  Eigen::VectorXd x;  ///< within its bounds; empty if the engine failed
  Certificate certificate;
};

/// Solves a program. Never throws for what the program holds: a failure is a certificate that says why.
/// `settings.name` is one of engine_names().
Solution solve(const ConvexProgram& program, const EngineSettings& settings);

std::vector<std::string> engine_names();

}  // namespace evbal

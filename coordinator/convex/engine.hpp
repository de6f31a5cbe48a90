#pragma once

#include "common/eigen.hpp"
#include "coordinator/convex/certificate.hpp"
#include "coordinator/convex/convex_program.hpp"
#include "coordinator/convex/start.hpp"

#include <functional>
#include <string>
#include <vector>

namespace evbal {

struct EngineSettings;

/// A point, and what is known of it.
struct Solution {
  Eigen::VectorXd x;        ///< within its bounds; empty if the engine failed
  Certificate certificate;  ///< whether it is an optimum
  Start start = {};         ///< from where `cuts` may solve a similar program; empty if another engine solved
};

/// Solves a program, or says in the certificate why not.
using Engine = std::function<Solution(const ConvexProgram&, const EngineSettings&)>;

/// Which engine solves, and how much work it may spend. Never a wall clock: results must not depend on the machine's
/// speed.
struct EngineSettings {
  std::string name = "ipopt";  ///< one of engine_names()
  int max_iterations = 300;    ///< of the engine's own kind: Newton steps of `ipopt`, linear programs of `cuts`
  Engine own = {};             ///< solves in place of the engine of that name, where given
};

/// Solves a program. Never throws for what the program holds: a failure is a certificate that says why, and so is a
/// program with a number that is not finite or beyond `largest_number`, on which the libraries below end the process.
///
/// `settings.name` is one of engine_names(). `cuts` may solve in several threads, a program in each. `ipopt` may not:
/// its linear solver (MUMPS) keeps its state in globals, so that a second solve that starts meanwhile ends the process;
/// solve in processes of their own instead.
///
/// `cuts` starts where the solve of a similar program ended, Solution::start, or afresh if that is empty; the other
/// engines have no use for it.
Solution solve(const ConvexProgram& program, const EngineSettings& settings, const Start& start = {});

/// The engines that there are.
std::vector<std::string> engine_names();

}  // namespace evbal

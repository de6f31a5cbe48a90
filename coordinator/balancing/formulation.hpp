#pragma once

#include "coordinator/balancing/arcs.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/balancing/uncertainty_model.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <vector>

namespace evbal {

/// The flow on an arc and the variable that says how much.
struct ArcFlow {
  Arc arc;
  Variable amount;
};

/// The balancing problem of one controller as a convex program, and where its decisions stand in it.
struct Formulation {
  ConvexProgram program;
  std::vector<std::vector<ArcFlow>> vacant;       ///< x, per step
  std::vector<std::vector<ArcFlow>> low_battery;  ///< y, per step
};

/// Writes down model, section 2. The horizon is the number of columns of `data.points`; the data are complete and
/// sound.
Formulation formulate(const BalancingParameters& parameters, const PlanningData& data,
                      const FormulationOptions& options);

/// The decisions at a point of the program; flows below 1e-6 vehicles are left out.
Dispatch dispatch_at(const Formulation& formulation, const Eigen::VectorXd& x);

}  // namespace evbal

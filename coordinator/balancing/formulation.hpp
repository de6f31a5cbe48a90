#pragma once

#include "coordinator/balancing/arcs.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/balancing/uncertainty_model.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <vector>

// The balancing problem
// =====================
//
// Vacant cars are sent to where passengers will be, low-battery cars to where they can charge, over a horizon of tau
// steps of Delta minutes, of which only the first is carried out. The problem is that of
//
//   He, Pepin, Wang, Zhang and Miao: Data-Driven Distributionally Robust Electric Vehicle Balancing for
//   Mobility-on-Demand Systems under Demand and Supply Uncertainties, IROS 2020,
//
// whose equation labels stand in brackets, as mended where it does not hold as printed (docs/model.md, section 1).
//
// Regions i = 1..N; C: the regions with working points at some step. A superscript + is the next step. The data are
// PlanningData (problem.hpp), r_hat, c_hat, c_low and laws of demand are UncertaintyModel (uncertainty_model.hpp).
//
//   V vacant, O occupied (by destination), L low-battery, B plugged    at the start of a step; of the first: data
//   S vacant, Y low-battery                                            after dispatch
//   x_ij vacant and y_ij low-battery cars sent,  u_i plugged in,  e_i released,  z_i plugged in without a point
//
//   x_ij >= 0, only where w_ij < m1, i != j; y_ij >= 0, only where w_ij < m2, i != j, j in C              arcs [bound]
//      (and to the nearest region and station, whatever m1 and m2)
//
//   S_i = V_i + sum_j x_ji - sum_j x_ij             "supply"                                    send_vacant() [trans]
//   sum_j x_ij <= V_i                               "sent"
//   Y_i = L_i + sum_j y_ji - sum_j y_ij             "low-battery"          send_low_battery()    [quality_charging_one]
//   sum_j y_ij <= L_i                               "sent to charge"
//
//   u_i <= Y_i                                      "plugged in"                                            charge()
//   u_i <= P_i - B_i + e_i + z_i                    "points"          u_i = z_i = 0 outside C
//   e_i <= B_i,  e_i <= c_low_i                     "released"
//
//   V+_i = sum_j Pv_ji S_j + sum_j Qv_ji O_j + e_i + aV_i      "V"                            next_stock()      [trans]
//   O+_i = sum_j Po_ji S_j + sum_j Qo_ji O_j                   "O"                                              [trans]
//   L+_i = Y_i - u_i + sum_j Pl_ji S_j + aL_i                  "L"                                        [con_charing]
//   B+_i = B_i + u_i - e_i                                     "B"
//      (aV, aL: cars under way without passengers that arrive in the step; V + O + L + B grows by these alone)
//
//   min  sum over the steps of                                 term                                         [obj_final]
//          sum_ij w_ij x_ij + beta sum_ij w_ij y_ij            "km"            send_*()                      [obj_dist]
//          omega sum_i (Y_i - u_i)                             "queue"         charge()
//          pi_e sum_i (c_low_i - e_i)                          "release"       charge()
//          the price of too few vehicles in the regions        "shortage"      shortage_terms.cpp      [quality_region]
//          the price of too many                               "surplus"       shortage_terms.cpp      [quality_region]
//          1000 sum_i z_i                                      "penalty"       charge()
//      + theta sup E[ sum_k sum_(i in C) c_i Z_i ]             "utilisation"   utilisation()     [quality_charging_one]
//          Z_i >= (Y_i + eps)^(-a),   theta = theta_0 / a
//
//   The supremum over the laws of c within the ambiguity set [uncertain_delta] is, over the whole horizon,
//          c_hat'Z + sqrt(g) || Sigma_c^(1/2) Z ||,   g = min(g1, g2)
//   written down by utilisation() and worst_case_utilisation(). It takes the place of Theorem 1 [thm1]:
//   docs/theorem-1.md.
//
// The band l_i <= r_i / S_i <= h_i [quality_region, quality_equ] is not a constraint here, but priced, so that every
// demand has a plan. How, is what sets controllers apart (docs/controllers.md): shortage_terms.cpp.
//
// Names in quotes are those that a certificate uses when a row is violated, with region and step: "supply[3], step 1".

namespace evbal {

/// The flow on an arc and the variable that says how much.
struct ArcFlow {
  Arc arc;
  Variable amount;
};

/// The balancing problem of one controller as a convex program, and where its decisions stand in it.
struct Formulation {
  ConvexProgram program{"vehicles"};
  std::vector<std::vector<ArcFlow>> vacant;       ///< x, per step
  std::vector<std::vector<ArcFlow>> low_battery;  ///< y, per step
};

/// Writes down the problem above (docs/model.md, section 2). The horizon is the number of columns of `data.points`; the
/// data are complete and sound (validate.hpp).
Formulation formulate(const BalancingParameters& parameters, const PlanningData& data,
                      const FormulationOptions& options);

/// The decisions at a point of the program; flows below 1e-6 vehicles are left out.
Dispatch dispatch_at(const Formulation& formulation, const Eigen::VectorXd& x);

}  // namespace evbal

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
// Data are PlanningData and BalancingParameters (problem.hpp); r_hat, c_hat, c_low and the laws of demand are
// UncertaintyModel (uncertainty_model.hpp). Regions i, j = 1..N, with C those where points work at some step; a + marks
// the next step.
//
//   V, O, L, B          vacant, occupied (by destination), low-battery and plugged cars at the start of a step
//   S, Y                vacant and low-battery cars after dispatch
//   x_ij, y_ij          vacant and low-battery cars sent from i to j; only on arcs, see below
//   u_i, e_i            cars plugged in, and released
//   z_i                 cars plugged in without a point, where an outage left fewer points than cars
//   t_i                 vacant cars that are told to charge where they stand, in the first step (top_up.hpp). They come
//                       back among aV of the step in which a mean session has passed; until then P is by them less
//
//   constraint, where x, y, u, e, z >= 0                   row              written by         paper
//
//   S_i = V_i + aV_i - t_i + sum_j x_ji - sum_j x_ij       "supply"         send_vacant        [trans]
//   aV_i + sum_j x_ji <= S_i,  that is
//                              t_i + sum_j x_ij <= V_i     "sent"           send_vacant
//   Y_i = L_i + aL_i + sum_j y_ji - sum_j y_ij             "low-battery"    send_low_battery   [quality_charging_one]
//   aL_i + sum_j y_ji <= Y_i,  that is
//                                    sum_j y_ij <= L_i     "sent to charge" send_low_battery
//   sum_(j: w_ij >= w) y_ij <= R_i(w),  all w              "within reach"   stay_within_reach
//   t_i <= T_i                                             bound            add_top_ups
//   u_i <= Y_i                                             "plugged in"     plug_in
//   u_i <= P_i - B_i + e_i + z_i                           "points"         plug_in
//   e_i <= B_i                                             "released"       release
//   e_i <= c_low_i                                         bound            release
//   V+_i = sum_j Pv_ji S_j + sum_j Qv_ji O_j + e_i         -                next_stock         [trans]
//   O+_i = sum_j Po_ji S_j + sum_j Qo_ji O_j               "O"              next_stock         [trans]
//   L+_i = Y_i - u_i + sum_j Pl_ji S_j                     -                next_stock         [con_charing]
//   B+_i = B_i + u_i - e_i                                 -                next_stock
//   Z_i >= (Y_i + eps)^(-a)                                curve of "Z"     utilisation        [thm1]
//   S_i = the sum of parts of its own price (hinges.hpp)   "shortage"       shortage_terms.cpp [quality_region]
//
//   A solver's time grows with the rows. So what stands in one row only, or is short, has no variable: V, L, B, and Y
//   outside C, where nobody is sent to charge. Nor has what is zero: x and y from where there is no car, u and z
//   outside C, e where no car is plugged. z_i has one in a step in which P_i is less than B_i of the first step:
//   elsewhere the plugged cars have points. O of the last step leads to nothing and is left out. In the first step
//   e_i <= B_i is a bound, since B_i is a number.
//
//   Arcs (arcs.hpp, [bound]): x_ij where w_ij < m1, y_ij where w_ij < m2 and j in C, i != j; whatever m1 and m2, those
//   to and from the nearest region and to the nearest station. aV, aL: cars without passengers that were under way and
//   arrive in the step, each for the share of it that is left, with the rest in the next. They cannot be sent on in it.
//   By rows of P and Q that sum to one, V + O + L + B grows by these alone. R_i(w), in the first step: low-battery cars
//   whose charge lasts for w km.
//
//   objective, summed over steps and regions               term             written by         paper
//
//   sum_j w_ij x_ij + beta sum_j w_ij y_ij                 "km"             send_...           [obj_dist]
//   omega (Y_i - u_i)                                      "queue"          charge
//   pi_e (c_low_i - e_i)                                   "release"        charge
//   top_up (T_i - t_i)                                     "top-up"         add_top_ups
//   p_s E[(r_i - h S_i)_+]                                 "shortage"       shortage_terms.cpp [quality_region]
//   p_o E[(l S_i - r_i)_+]                                 "surplus"        shortage_terms.cpp [quality_region]
//   theta sup E[c_i Z_i],  theta = theta_0 / a             "utilisation"    utilisation        [quality_charging_one]
//   1000 z_i                                               "penalty"        plug_in
//
//   The band l <= r_i / S_i <= h of [quality_region, quality_equ], h, l = rho (1 +- eta), is priced and no constraint,
//   so that every demand has a plan; rho is the city's predicted demand per vacant car without dispatch. Which law E
//   takes, and other forms of a shortage, is what sets the controllers apart (docs/controllers.md).
//
//   The supremum over the laws of c within the ambiguity set [uncertain_delta] is, over the whole horizon,
//       c_hat'Z + sqrt(g) || Sigma_c^(1/2) Z ||,   g = min(g1, g2),
//   the norm written by worst_case_utilisation. It takes the place of Theorem 1 [thm1] in the paper's problem
//   [obj_final]: docs/theorem-1.md.
//
// A certificate calls a row that is violated by the name in quotes, with region and step from 0: "supply[3], step 1".

namespace evbal {

/// The flow on an arc and the variable that says how much.
struct ArcFlow {
  Arc arc;          ///< the way
  Variable amount;  ///< vehicles sent on it
};

/// A quantity of every region.
using Expressions = std::vector<Expression>;

/// The vehicles at the start of a step.
struct Stock {
  Expressions V;  ///< vacant
  Expressions O;  ///< occupied, by destination; left out in the last of several steps
  Expressions L;  ///< low-battery
  Expressions B;  ///< plugged
};

/// The balancing problem of one controller as a convex program, and where its decisions stand in it.
struct Formulation {
  ConvexProgram program{"vehicles"};              ///< the problem
  std::vector<std::vector<ArcFlow>> vacant;       ///< x, per step
  std::vector<std::vector<ArcFlow>> low_battery;  ///< y, per step
  std::vector<ArcFlow> top_up;                    ///< t, in the first step
  std::vector<Stock> stock;                       ///< V, O, L, B, per step
};

/// Writes down the problem above (docs/model.md, section 2). The horizon is the number of columns of `data.points`; the
/// data are complete and sound (validate.hpp).
Formulation formulate(const BalancingParameters& parameters, const PlanningData& data,
                      const FormulationOptions& options);

/// The decisions at a point of the program; flows below 1e-6 vehicles are left out.
Dispatch dispatch_at(const Formulation& formulation, const Eigen::VectorXd& x);

}  // namespace evbal

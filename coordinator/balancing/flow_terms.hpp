#pragma once

#include "coordinator/balancing/formulation.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/balancing/uncertainty_model.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <vector>

// The vacant cars of `flow`
// =========================
//
// `flow` plans vacant cars by their minutes of arrival, in slots k = 0..K-1 of delta minutes, in place of S_i in steps
// of Delta (formulation.hpp). Where low-battery cars go is the problem there, with the S_i that are expected if nobody
// is sent. Cars and passengers are counted from now to the end of a slot:
//
//   C_i(k)       vacant cars that region i has had by then, so many passengers it can serve;  C_i(-1) = V_i
//   freed_i(k)   cars that become vacant there by then if nobody is sent (FreedCars);  freed_i(-1) = 0
//   N_i(k)       passengers who have to have a car there by then: who want one flow_patience earlier (CumulativeDemand)
//   x_ij(m)      cars that set off from i to j at the start of slot m = 0..2
//
//   C_i(k) = C_i(k-1) + freed_i(k) - freed_i(k-1) + in_i(k) - out_i(k)          row "cars"
//   out_i(m) <= C_i(m-1)                                                        row "set off"
//   min  sum w_ij x_ij(m)  +  sum p_ik E[(N_i(k) - C_i(k))_+]                   terms "km" and "shortage"
//                          +  sum theta (max lambda - lambda_i) C_i(K-1)        term "worth"
//        p_ik = p_f (1 - end) / K,  but  ((1 - end) / K + end) p_f + theta (mu_i - lambda_i)  in the last slot,
//        and at least 0; theta = flow_value, 0 where no worth is known; end = (1 - theta) flow_end
//
// At the end of the last slot a car that is left over is worth lambda_i, one that took a passenger mu_i (CarWorth). All
// cars together being as many wherever they are, what is paid for is that some are not where they are worth most.
//
//   out_i(m) = sum_j x_ij(m);   in_i(k) = sum of those x_ji(m) for which k is the first slot with
//   m delta + t_ji <= (k+1) delta.  Cars that top up (top_up.hpp) set off in slot 0 too, and are back after a mean
//   session.  Arcs (arcs.hpp) are those within flow_m1 and flow_neighbours, and only where cars
//   arrive within the K slots. N_i(k) is negative binomial; its variance is that of demand around its forecast
//   and that of freed_i(k) together, for only N_i - C_i matters.
//
// C_i(k) is the sum of parts of its own price (hinges.hpp): between two neighbouring values of N_i(k) the expected
// shortage falls along a line. Names count slots as steps.

namespace evbal {

/// Adds the problem above to the program. Gives the x_ij(0), by (i, j): what is carried out before the next plan. The
/// number of slots is that of the columns of `data.freed`; `top_ups` are variables of the program. N_i(k) is what is
/// expected, surely, if `demand` is Uncertainty::mean.
std::vector<ArcFlow> add_flow(const BalancingParameters& parameters, const PlanningData& data, Uncertainty demand,
                              const std::vector<ArcFlow>& top_ups, ConvexProgram& program);

}  // namespace evbal

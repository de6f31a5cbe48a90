#pragma once

#include "common/eigen.hpp"
#include "coordinator/ambiguity/moment_set.hpp"
#include "coordinator/convex/certificate.hpp"
#include "coordinator/convex/start.hpp"
#include "coordinator/forecast/count_variance.hpp"

#include <string>
#include <vector>

namespace evbal {

/// What J_E takes the supply of charging to be (docs/model.md, section 4).
enum class Supply {
  completions,  ///< charging sessions that end in the step, as the paper
  points,       ///< points free by the step's end: those free now, and plugged cars that finish
};

/// Prices and bounds of the balancing problem (docs/model.md, sections 2 and 4), tuned on tuning seeds only.
struct BalancingParameters {
  double a = 0.1;            ///< power of the utilisation term J_E; smaller equalises more
  double theta_0 = 20.0;     ///< weight of J_E is theta_0 / a
  double eps = 1.0;          ///< vehicles; keeps J_E finite where no car waits
  double beta = 1.0;         ///< price of a low-battery car's km against a vacant one's
  double omega = 10.0;       ///< km per low-battery car that waits a step for a charger
  double pi_e = 20.0;        ///< km per charged car kept plugged in for a step
  double p_shortage = 12.0;  ///< km per vehicle missing below the band
  double p_surplus = 3.0;    ///< km per vehicle above the band
  double p_ratio = 30.0;     ///< km per expected passenger that each vehicle has to serve (ratio only)
  double eta = 0.2;          ///< half-width of the band around the city's demand-supply ratio
  double m1 = 10.0;          ///< km; vacant cars are sent to regions nearer than this
  double m2 = 15.0;          ///< km; low-battery cars likewise
  int neighbours = 12;       ///< at most so many nearest targets a region, beside its nearest region and station
  int tau = 2;               ///< steps in the horizon
  double top_up = 3.0;       ///< km per vacant car that charges where it stands, at a point that would stay free
  Supply supply = Supply::completions;  ///< what J_E takes the supply to be
  double p_flow = 72.0;        ///< km per passenger who goes without a car for the whole time ahead (flow only)
  int flow_slot = 10;          ///< minutes of a slot (the flow_... are for `flow` only)
  int flow_slots = 9;          ///< slots that `flow` looks ahead
  int flow_sends = 3;          ///< the first so many slots are those in which cars may set off
  double flow_m1 = 25.0;       ///< as m1
  int flow_neighbours = 35;    ///< as neighbours
  double flow_end = 0.5;       ///< share of p_flow that stands on having no car by the end of all slots, less the share
                               ///< flow_value of it where CarWorth is known
  double flow_patience = 9.0;  ///< minutes that a passenger may wait for a car without cost
  double flow_served = 0.95;   ///< at most this share of the passengers to come is served and gets out again
  double flow_pickup = 2.0;    ///< minutes that a passenger who is served waits
  double flow_value = 0.6;     ///< share of CarWorth that counts
};

/// Vehicles as they stand when a plan is made; all N, in vehicles.
struct FleetState {
  Eigen::VectorXd vacant;                  ///< V1
  Eigen::VectorXd chargeable;              ///< of these, cars that may be told to charge where they stand
  Eigen::VectorXd occupied;                ///< O1, by destination
  Eigen::VectorXd low_battery;             ///< L1
  std::vector<std::vector<double>> reach;  ///< by region, km that low-battery cars can still drive, ascending, of those
                                           ///< that do not get to every region
  Eigen::VectorXd plugged;                 ///< B1
  Eigen::VectorXd waiting;                 ///< passengers waiting now
  /// aV, N x tau: cars under way. One counts in S of the step in which it arrives, for the share of the step that is
  /// left then, and with the rest in S of the next.
  Eigen::MatrixXd arriving_vacant;
  Eigen::MatrixXd arriving_low_battery;  ///< aL, N x tau: likewise, in Y
  Eigen::MatrixXd dropoffs_due;          ///< N x tau: of the occupied cars, those that arrive in step k
};

/// Row-stochastic transitions of one step (docs/model.md, section 2): entry (j, i) is the share of the vehicles of j
/// that are in i, in the new state, one step later.  rows of Pv + Po + Pl and of Qv + Qo sum to one.
struct Transitions {
  Eigen::MatrixXd vacant_to_vacant;       ///< Pv
  Eigen::MatrixXd vacant_to_occupied;     ///< Po, i = destination
  Eigen::MatrixXd vacant_to_low_battery;  ///< Pl
  Eigen::MatrixXd occupied_to_vacant;     ///< Qv
  Eigen::MatrixXd occupied_to_occupied;   ///< Qo
};

/// What a city's records and plant say of vehicles that serve more than once a step (turnover, oracle).
struct Turnover {
  CountVariance demand;                ///< of passengers around their forecast
  double phi = 0.0;                    ///< share of drop-offs that serve again in the same step
  Eigen::MatrixXd same_step_dropoffs;  ///< D, N x N: share of the trips from j that end at i within the step
};

/// Cars that become vacant in the next K slots if nobody is sent anywhere, beside those that are; cumulative from now,
/// each up to the end of the slot (docs/model.md, section 4: `flow`). Those who wait for a charger are not among them.
struct FreedCars {
  Eigen::MatrixXd mean;      ///< N x K: expected number
  Eigen::MatrixXd variance;  ///< N x K: of that number
};

/// What a car is worth at the end of the last slot, in km of empty driving (docs/model.md, section 4: `flow`); N each,
/// or none, where nothing is known of it.
struct CarWorth {
  Eigen::VectorXd vacant;   ///< lambda, of one that stands vacant in a region
  Eigen::VectorXd serving;  ///< mu, of one that takes a passenger there
};

/// Everything that a controller may know when it plans.
struct PlanningData {
  Eigen::MatrixXd km;                    ///< N x N
  FleetState state;                      ///< the vehicles now
  Eigen::MatrixXd points;                ///< P, N x tau: working points per step
  MomentSet demand;                      ///< r
  Eigen::MatrixXd demand_samples;        ///< N tau x any: demand as it may come, each column equally likely
  MomentSet completions;                 ///< c, sessions that end in each step
  MomentSet free_points;                 ///< c of Supply::points, free by the end of each step
  std::vector<Transitions> transitions;  ///< tau of them
  Turnover turnover;                     ///< of vehicles that serve twice in a step
  FreedCars freed;                       ///< by the end of each slot (flow only)
  CarWorth worth;                        ///< at the end of the last slot (flow only)
  double step_minutes = 30.0;            ///< Delta
  double mean_session_minutes = 45.0;    ///< caps J_E's c_hat at P Delta / mean session; who tops up is away for it
  Eigen::MatrixXd minutes;               ///< N x N travel time (greedy and flow only)
  Start start;                           ///< BalancingResult::start of the last plan; empty: the engine starts afresh
};

/// A planned flow of vehicles.
struct Flow {
  int from = 0;         ///< region
  int to = 0;           ///< region
  double amount = 0.0;  ///< vehicles
};

/// What a controller decides, per step of the horizon.
struct Dispatch {
  std::vector<std::vector<Flow>> vacant;       ///< x, by (from, to)
  std::vector<std::vector<Flow>> low_battery;  ///< y, by (from, to)
  std::vector<Flow> top_up{};                  ///< t: vacant cars that charge where they stand, at once; from == to
};

/// A plan and what it is worth.
struct BalancingResult {
  Dispatch dispatch;        ///< empty if no optimum was found
  Certificate certificate;  ///< whether it is an optimum
  /// The objective by term, in km of empty driving, as formulation.hpp names them: "km", "queue", "release",
  /// "shortage", "surplus", "utilisation", "penalty", "worth". They sum to certificate.objective but for rounding; none
  /// if nothing was solved.
  std::vector<CostTerm> cost;
  Start start = {};  ///< from where the engine may solve the next plan: PlanningData::start
};

}  // namespace evbal

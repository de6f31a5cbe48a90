#pragma once

#include "common/eigen.hpp"
#include "coordinator/balancing/discrete_distribution.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <functional>
#include <vector>

namespace evbal {

/// How too few (and too many) vehicles in a region are priced (docs/model.md, sections 3 and 4).
enum class Shortage {
  band,      ///< vehicles missing below the band and in excess above it, in expectation
  moments,   ///< the same, in the worst expectation over the ambiguity set
  ratio,     ///< expected passengers per vehicle
  turnover,  ///< passengers for whom neither a vehicle nor one that drops off in time is there, in expectation
  flow,      ///< the same slot by slot, in place of S by where cars are at the end of each (flow_terms.hpp)
  own,       ///< FormulationOptions::own
};

/// What a controller takes an uncertain quantity to be.
enum class Uncertainty {
  mean,        ///< the forecast
  worst_case,  ///< the worst mean of the ambiguity set
  samples,     ///< one of the samples (demand only)
  counts,      ///< negative binomial around the forecast (demand only)
};

struct UncertaintyModel;

/// Adds the price of shortages in step k to the program; `S` are the vacant vehicles of the regions after dispatch, and
/// the price is convex in them.
using OwnShortage =
    std::function<void(int k, const Variables& S, const UncertaintyModel& model, ConvexProgram& program)>;

/// How the controllers of one problem differ (docs/model.md, section 4).
struct FormulationOptions {
  Shortage shortage = Shortage::band;      ///< how it is priced
  Uncertainty demand = Uncertainty::mean;  ///< of r
  Uncertainty supply = Uncertainty::mean;  ///< of c
  OwnShortage own{};                       ///< of Shortage::own, whose demand is not `counts`
};

/// Forecasts as the balancing problem uses them; matrices are N x tau, laws stand step-major.
struct UncertaintyModel {
  Eigen::MatrixXd r_hat;                       ///< expected demand, >= 0
  std::vector<DiscreteDistribution> shortage;  ///< demand in the shortage
  std::vector<DiscreteDistribution> surplus;   ///< demand in the surplus
  Eigen::MatrixXd serving_again;  ///< vehicles beside S that serve in the step; zero unless drop-offs count
  Eigen::MatrixXd c_hat;          ///< supply of charging in J_E, within what the points allow
  Eigen::MatrixXd c_low;          ///< completions that releases count on, >= 0
  double supply_radius = 0.0;     ///< sqrt(g) in front of J_E's norm; 0: no norm
};

/// The supply of charging that `parameters` choose.
const MomentSet& supply_of(const BalancingParameters& parameters, const PlanningData& data);

/// The forecasts under these options (docs/model.md, sections 3 and 4): with  g = min(g1, g2)  the worst mean of one
/// entry is  mean +- sqrt(g) sigma.  Laws that options.shortage has no use for are left out.
UncertaintyModel uncertainty_model(const BalancingParameters& parameters, const PlanningData& data,
                                   const FormulationOptions& options);

/// S of each step if nobody is sent anywhere, N x tau; the dynamics of docs/model.md, section 2.
Eigen::MatrixXd vacant_without_dispatch(const PlanningData& data, const Eigen::MatrixXd& c_low);

/// rho_k, the city's predicted demand per vacant vehicle without dispatch (docs/model.md, section 2), tau values.
Eigen::VectorXd demand_per_vehicle(const PlanningData& data, const UncertaintyModel& model);

}  // namespace evbal

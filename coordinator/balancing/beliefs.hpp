#pragma once

#include "coordinator/balancing/problem.hpp"

#include <Eigen/Core>

namespace evbal {

/// What a controller takes an uncertain quantity to be.
enum class Belief {
  mean,        ///< the forecast
  worst_case,  ///< the worst mean of the ambiguity set
};

/// How the controllers of one problem differ (model, section 4).
struct Switches {
  Belief demand = Belief::mean;
  Belief supply = Belief::mean;
};

/// Forecasts as the balancing problem uses them; matrices are N x tau.
struct Beliefs {
  Eigen::MatrixXd r_hat;       ///< expected demand, >= 0
  Eigen::MatrixXd r_hi;        ///< demand in the shortage
  Eigen::MatrixXd r_lo;        ///< demand in the surplus
  Eigen::MatrixXd c_hat;       ///< completions in J_E: within [0, P Delta / mean session]
  Eigen::MatrixXd c_low;       ///< completions that releases count on, >= 0
  double supply_radius = 0.0;  ///< sqrt(g) in front of J_E's norm; 0: no norm
};

/// Reads the switches (model, section 3): with  g = min(g1, g2)  the worst mean of one entry is  mean +- sqrt(g) sigma.
Beliefs beliefs(const PlanningData& data, const Switches& switches);

/// Vacant vehicles at the start of each step if nobody is sent anywhere, N x tau; the dynamics of model, section 2.
Eigen::MatrixXd vacant_without_dispatch(const PlanningData& data, const Eigen::MatrixXd& c_low);

/// rho_k, the city's predicted demand per vacant vehicle without dispatch (model, section 2), tau values.
Eigen::VectorXd demand_per_vehicle(const PlanningData& data, const Beliefs& beliefs);

}  // namespace evbal

#include "coordinator/balancing/beliefs.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

// Mean + radii * standard deviation of every entry, never negative, as N x tau.
Eigen::MatrixXd shifted(const MomentSet& set, double radii, Eigen::Index regions) {
  const Eigen::VectorXd stacked = (set.mean + radii * set.standard_deviation()).cwiseMax(0.0);
  return stacked.reshaped(regions, stacked.size() / regions);
}

double radius(const MomentSet& set, Belief belief) {
  return belief == Belief::mean ? 0.0 : std::sqrt(std::min(set.g1, set.g2));
}

}  // namespace

Beliefs beliefs(const PlanningData& data, const Switches& switches) {
  const auto regions = data.km.rows();
  const double demand_radius = radius(data.demand, switches.demand);
  const double supply_radius = radius(data.completions, switches.supply);
  const Eigen::MatrixXd capacity = data.points * (data.step_minutes / data.mean_session_minutes);
  return {.r_hat = shifted(data.demand, 0.0, regions),
          .r_hi = shifted(data.demand, demand_radius, regions),
          .r_lo = shifted(data.demand, -demand_radius, regions),
          .c_hat = shifted(data.completions, 0.0, regions).cwiseMin(capacity),
          .c_low = shifted(data.completions, -supply_radius, regions),
          .supply_radius = supply_radius};
}

Eigen::MatrixXd vacant_without_dispatch(const PlanningData& data, const Eigen::MatrixXd& c_low) {
  const auto& state = data.state;
  Eigen::MatrixXd vacant(data.km.rows(), data.points.cols());
  Eigen::VectorXd v = state.vacant;
  Eigen::VectorXd o = state.occupied;
  Eigen::VectorXd l = state.low_battery;
  Eigen::VectorXd b = state.plugged;
  for (Eigen::Index k = 0; k < vacant.cols(); ++k) {
    vacant.col(k) = v;
    const auto& move = data.transitions[static_cast<std::size_t>(k)];
    const Eigen::VectorXd e = b.cwiseMin(c_low.col(k));
    const Eigen::VectorXd u = l.cwiseMin((data.points.col(k) - b + e).cwiseMax(0.0));
    const Eigen::VectorXd v_next = move.vacant_to_vacant.transpose() * v + move.occupied_to_vacant.transpose() * o + e +
                                   state.arriving_vacant.col(k);
    o = (move.vacant_to_occupied.transpose() * v + move.occupied_to_occupied.transpose() * o).eval();
    l = (l - u + move.vacant_to_low_battery.transpose() * v + state.arriving_low_battery.col(k)).eval();
    b += u - e;
    v = v_next;
  }
  return vacant;
}

Eigen::VectorXd demand_per_vehicle(const PlanningData& data, const Beliefs& beliefs) {
  constexpr double least_vehicles = 1.0;
  constexpr double least_ratio = 1e-3;
  const Eigen::MatrixXd vacant = vacant_without_dispatch(data, beliefs.c_low);
  const Eigen::ArrayXd vehicles = vacant.colwise().sum().transpose().array().max(least_vehicles);
  return (beliefs.r_hat.colwise().sum().transpose().array() / vehicles).max(least_ratio);
}

}  // namespace evbal

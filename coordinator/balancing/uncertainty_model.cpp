#include "coordinator/balancing/uncertainty_model.hpp"

#include "coordinator/balancing/dropoffs.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

// Mean + radii * standard deviation of every entry, never negative, as N x tau.
Eigen::MatrixXd shifted(const MomentSet& set, double radii, Eigen::Index regions) {
  const Eigen::VectorXd stacked = (set.mean + radii * set.standard_deviation()).cwiseMax(0.0);
  return stacked.reshaped(regions, stacked.size() / regions);
}

double radius(const MomentSet& set, Uncertainty uncertainty) {
  return uncertainty == Uncertainty::worst_case ? std::sqrt(std::min(set.g1, set.g2)) : 0.0;
}

// Laws of the demand in both sides of the band.
void add_band_demand(const PlanningData& data, Uncertainty uncertainty, UncertaintyModel& model) {
  const double spread = radius(data.demand, uncertainty);
  const auto regions = data.km.rows();
  const Eigen::VectorXd high = shifted(data.demand, spread, regions).reshaped();
  const Eigen::VectorXd low = shifted(data.demand, -spread, regions).reshaped();
  for (Eigen::Index entry = 0; entry < high.size(); ++entry) {
    if (uncertainty == Uncertainty::samples) {
      const Eigen::VectorXd drawn = data.demand_samples.row(entry).cwiseMax(0.0);
      model.shortage.push_back(empirical({drawn.begin(), drawn.end()}));
      model.surplus.push_back(model.shortage.back());
    } else {
      model.shortage.push_back(certain(high(entry)));
      model.surplus.push_back(certain(low(entry)));
    }
  }
}

// Laws of the passengers who want to be served, around `demand`, N x tau.
std::vector<DiscreteDistribution> count_laws(const CountVariance& variance, const Eigen::MatrixXd& demand,
                                             Uncertainty uncertainty) {
  std::vector<DiscreteDistribution> laws;
  for (Eigen::Index k = 0; k < demand.cols(); ++k) {
    for (const double m : demand.col(k)) {
      laws.push_back(uncertainty == Uncertainty::mean ? certain(m) : negative_binomial(m, variance.at(k, m)));
    }
  }
  return laws;
}

}  // namespace

const MomentSet& supply_of(const BalancingParameters& parameters, const PlanningData& data) {
  return parameters.supply == Supply::completions ? data.completions : data.free_points;
}

UncertaintyModel uncertainty_model(const BalancingParameters& parameters, const PlanningData& data,
                                   const FormulationOptions& options) {
  const auto regions = data.km.rows();
  const double per_step =
      parameters.supply == Supply::completions ? data.step_minutes / data.mean_session_minutes : 1.0;
  UncertaintyModel model;
  model.r_hat = shifted(data.demand, 0.0, regions);
  model.c_hat = shifted(supply_of(parameters, data), 0.0, regions).cwiseMin(per_step * data.points);
  model.c_low = shifted(data.completions, -radius(data.completions, options.supply), regions);
  model.supply_radius = radius(supply_of(parameters, data), options.supply);
  model.serving_again = Eigen::MatrixXd::Zero(regions, data.points.cols());
  if (options.shortage == Shortage::band || options.shortage == Shortage::own) {
    add_band_demand(data, options.demand, model);
  } else if (options.shortage == Shortage::turnover) {
    const Eigen::MatrixXd demand = demand_with_waiting(data);
    const Eigen::MatrixXd vacant = vacant_without_dispatch(data, model.c_low);
    model.serving_again = serving_again(data, dropoffs(data, demand, vacant));
    model.shortage = count_laws(data.turnover.demand, demand, options.demand);
  }
  return model;
}

Eigen::MatrixXd vacant_without_dispatch(const PlanningData& data, const Eigen::MatrixXd& c_low) {
  const auto& state = data.state;
  Eigen::MatrixXd vacant(data.km.rows(), data.points.cols());
  Eigen::VectorXd v = state.vacant;
  Eigen::VectorXd o = state.occupied;
  Eigen::VectorXd l = state.low_battery;
  Eigen::VectorXd b = state.plugged;
  for (Eigen::Index k = 0; k < vacant.cols(); ++k) {
    v += state.arriving_vacant.col(k);
    l += state.arriving_low_battery.col(k);
    vacant.col(k) = v;
    const auto& move = data.transitions[static_cast<std::size_t>(k)];
    const Eigen::VectorXd e = b.cwiseMin(c_low.col(k));
    const Eigen::VectorXd u = l.cwiseMin((data.points.col(k) - b + e).cwiseMax(0.0));
    const Eigen::VectorXd v_next = move.vacant_to_vacant.transpose() * v + move.occupied_to_vacant.transpose() * o + e;
    o = (move.vacant_to_occupied.transpose() * v + move.occupied_to_occupied.transpose() * o).eval();
    l = (l - u + move.vacant_to_low_battery.transpose() * v).eval();
    b += u - e;
    v = v_next;
  }
  return vacant;
}

Eigen::VectorXd demand_per_vehicle(const PlanningData& data, const UncertaintyModel& model) {
  constexpr double least_vehicles = 1.0;
  constexpr double least_ratio = 1e-3;
  const Eigen::MatrixXd vacant = vacant_without_dispatch(data, model.c_low);
  const Eigen::ArrayXd vehicles = vacant.colwise().sum().transpose().array().max(least_vehicles);
  return (model.r_hat.colwise().sum().transpose().array() / vehicles).max(least_ratio);
}

}  // namespace evbal

#include "coordinator/balancing/top_up.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {

Eigen::VectorXd top_up_room(const PlanningData& data) {
  const FleetState& state = data.state;
  const Eigen::VectorXd due = state.plugged + state.low_battery + state.arriving_low_battery.rowwise().sum();
  return (data.points.col(0) - due).cwiseMin(state.chargeable).cwiseMin(state.vacant).cwiseMax(0.0).array().floor();
}

std::vector<ArcFlow> add_top_ups(const BalancingParameters& parameters, const PlanningData& data,
                                 ConvexProgram& program) {
  std::vector<ArcFlow> flows;
  const Eigen::VectorXd room = top_up_room(data);
  for (int i = 0; i < room.size(); ++i) {
    if (room(i) > 0.0) {
      const Variable cars = program.add_variable({"t", 0, i, i});
      program.bound(cars, 0.0, room(i));
      program.minimise("top-up", parameters.top_up * (room(i) - cars));
      flows.push_back({{i, i, 0.0}, cars});
    }
  }
  return flows;
}

std::vector<VehicleFlow> whole_top_ups(const std::vector<Flow>& flows, const PlanningData& data,
                                       const std::vector<VehicleFlow>& sent) {
  constexpr double solver_noise = 1e-6;
  Eigen::VectorXd left = data.state.vacant;
  for (const VehicleFlow& flow : sent) {
    left(flow.from) -= flow.vehicles;
  }
  left = left.cwiseMin(top_up_room(data));
  std::vector<VehicleFlow> whole;
  for (const Flow& flow : flows) {
    const double cars = std::min(std::floor(flow.amount + 0.5 + solver_noise), left(flow.from));
    if (cars >= 1.0) {
      whole.push_back({flow.from, flow.from, static_cast<int>(cars)});
      left(flow.from) -= cars;
    }
  }
  return whole;
}

}  // namespace evbal

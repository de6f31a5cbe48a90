#include "coordinator/balancing/dropoffs.hpp"

namespace evbal {

Eigen::MatrixXd demand_with_waiting(const PlanningData& data) {
  Eigen::MatrixXd demand = data.demand.mean.cwiseMax(0.0).reshaped(data.km.rows(), data.points.cols());
  demand.col(0) += still_there * data.state.waiting;
  return demand;
}

Eigen::MatrixXd dropoffs(const PlanningData& data, const Eigen::MatrixXd& demand, const Eigen::MatrixXd& vacant) {
  constexpr double in_time = 0.8;
  constexpr int passes = 4;  // a trip within a step takes most of it: few cars serve more than twice
  Eigen::MatrixXd A = data.state.dropoffs_due;
  for (int pass = 0; pass < passes; ++pass) {
    const Eigen::MatrixXd served = demand.cwiseMin(vacant + in_time * A);
    A = data.state.dropoffs_due + data.turnover.same_step_dropoffs.transpose() * served;
  }
  return A;
}

Eigen::MatrixXd serving_again(const PlanningData& data, const Eigen::MatrixXd& dropoffs) {
  Eigen::MatrixXd again = data.turnover.phi * dropoffs;
  for (Eigen::Index k = 0; k < again.cols(); ++k) {
    const Eigen::VectorXd low = data.transitions[static_cast<std::size_t>(k)].vacant_to_low_battery.rowwise().sum();
    again.col(k).array() *= 1.0 - low.array();
  }
  return again;
}

}  // namespace evbal

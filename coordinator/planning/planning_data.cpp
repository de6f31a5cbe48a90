#include "coordinator/planning/planning_data.hpp"

#include <algorithm>

namespace evbal {

int horizon_at(const DayClock& clock, int minute, int tau) {
  const int steps_left = (clock.minutes() - minute + clock.step - 1) / clock.step;
  return std::clamp(steps_left, 1, tau);
}

FleetState fleet_state(const std::vector<Report>& reports, int minute, int step, int tau) {
  const auto n = static_cast<Eigen::Index>(reports.size());
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(n);
  FleetState state{none, none, none, none, none, Eigen::MatrixXd::Zero(n, tau), Eigen::MatrixXd::Zero(n, tau)};
  for (const Report& report : reports) {
    const int i = report.region;
    state.vacant(i) = report.vacant;
    state.low_battery(i) = report.low_battery;
    state.plugged(i) = report.plugged;
    state.waiting(i) = report.waiting;
    for (const UnderWay& car : report.bound) {
      const int window = std::max(0, car.minute - minute) / step;
      if (car.errand == Errand::passenger) {
        state.occupied(i) += car.count;
      } else if (window < tau) {
        (car.errand == Errand::rebalance ? state.arriving_vacant : state.arriving_low_battery)(i, window) += car.count;
      }
    }
  }
  return state;
}

Eigen::MatrixXd points_ahead(const std::vector<Report>& reports, int tau) {
  Eigen::MatrixXd points(static_cast<Eigen::Index>(reports.size()), tau);
  for (const Report& report : reports) {
    points.row(report.region).setConstant(report.points);
  }
  return points;
}

}  // namespace evbal

#include "coordinator/planning/planning_data.hpp"

#include "coordinator/planning/charging_sessions.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

constexpr double least_deviation = 0.1;  ///< of an uncertain count (docs/model.md, section 5)

}  // namespace

int horizon_at(const DayClock& clock, int minute, int tau) {
  const int steps_left = (clock.minutes() - minute + clock.step - 1) / clock.step;
  return std::clamp(steps_left, 1, tau);
}

FleetState fleet_state(const std::vector<Report>& reports, int minute, int step, int tau) {
  const auto n = static_cast<Eigen::Index>(reports.size());
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(n);
  const Eigen::MatrixXd never = Eigen::MatrixXd::Zero(n, tau);
  FleetState state{none, none, none, none, none, never, never, never};
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
        if (window < tau) {
          state.dropoffs_due(i, window) += car.count;
        }
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

MomentSet free_points(const std::vector<Report>& reports, int minute, int step,
                      const std::vector<double>& session_quantiles, const MomentSet& completions) {
  const auto n = static_cast<Eigen::Index>(reports.size());
  MomentSet set = completions;
  set.factors.resize(set.mean.size(), 0);
  for (Eigen::Index entry = 0; entry < set.mean.size(); ++entry) {
    const Report& report = reports[static_cast<std::size_t>(entry % n)];
    const Eigen::Index lead = entry / n + 1;
    const auto minutes = static_cast<double>(step * lead);
    double mean = std::max(0, report.points - report.plugged);
    double variance = 0.0;
    for (const int since : report.plugged_since) {
      const double ends = share_that_ends(session_quantiles, minute - since, minutes);
      mean += ends;
      variance += ends * (1.0 - ends);
    }
    set.mean(entry) = mean;
    set.deviation(entry) = std::max(least_deviation, std::sqrt(variance));
  }
  return set;
}

}  // namespace evbal

#include "coordinator/planning/planning_data.hpp"

#include "coordinator/planning/charging_sessions.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

constexpr double least_deviation = 0.1;  ///< of an uncertain count (docs/model.md, section 5)

/// Cars that arrive in so many minutes count in that step for the share of it that is left, and with the rest in the
/// next.
void add_arrivals(Eigen::MatrixXd& arriving, int region, int minutes, int step, double cars) {
  const int window = minutes / step;
  const double missed = static_cast<double>(minutes % step) / step;
  if (window < arriving.cols()) {
    arriving(region, window) += (1.0 - missed) * cars;
  }
  if (window + 1 < arriving.cols()) {
    arriving(region, window + 1) += missed * cars;
  }
}

}  // namespace

int horizon_at(const DayClock& clock, int minute, int tau) {
  const int steps_left = (clock.minutes() - minute + clock.step - 1) / clock.step;
  return std::clamp(steps_left, 1, tau);
}

FleetState fleet_state(const std::vector<Report>& reports, int minute, int step, int tau) {
  const auto n = static_cast<Eigen::Index>(reports.size());
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(n);
  const Eigen::MatrixXd never = Eigen::MatrixXd::Zero(n, tau);
  FleetState state{.vacant = none,
                   .chargeable = none,
                   .occupied = none,
                   .low_battery = none,
                   .reach = std::vector<std::vector<double>>(reports.size()),
                   .plugged = none,
                   .waiting = none,
                   .arriving_vacant = never,
                   .arriving_low_battery = never,
                   .dropoffs_due = never};
  for (const Report& report : reports) {
    const int i = report.region;
    state.vacant(i) = report.vacant;
    state.chargeable(i) = report.chargeable;
    state.low_battery(i) = report.low_battery;
    for (const int metres : report.reach_m) {
      state.reach[static_cast<std::size_t>(i)].push_back(metres / 1000.0);
    }
    state.plugged(i) = report.plugged;
    state.waiting(i) = report.waiting;
    for (const UnderWay& car : report.bound) {
      const int in = std::max(0, car.minute - minute);
      if (car.errand == Errand::passenger) {
        state.occupied(i) += car.count;
        if (in / step < tau) {
          state.dropoffs_due(i, in / step) += car.count;
        }
      } else {
        auto& arriving = car.errand == Errand::rebalance ? state.arriving_vacant : state.arriving_low_battery;
        add_arrivals(arriving, i, in, step, car.count);
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

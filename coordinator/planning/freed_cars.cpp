#include "coordinator/planning/freed_cars.hpp"

#include "coordinator/balancing/cumulative_demand.hpp"
#include "coordinator/planning/charging_sessions.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

/// Adds cars on their way, each of which is vacant from the end of the slot in which it arrives.
void add_under_way(const Report& report, int minute, int slot, double fit, FreedCars& freed) {
  for (const UnderWay& cars : report.bound) {
    const double in = std::max(0, cars.minute - minute);
    const auto arrives = std::max<Eigen::Index>(0, static_cast<Eigen::Index>(std::ceil(in / slot)) - 1);
    const Eigen::Index slots_left = freed.mean.cols() - arrives;
    if (cars.errand == Errand::charge || slots_left <= 0) {
      continue;
    }
    const double share = cars.errand == Errand::passenger ? fit : 1.0;
    freed.mean.row(report.region).tail(slots_left).array() += share * cars.count;
    freed.variance.row(report.region).tail(slots_left).array() += share * (1.0 - share) * cars.count;
  }
}

/// Adds plugged cars whose session ends.
void add_plugged(const Report& report, int minute, int slot, const std::vector<double>& session_quantiles,
                 FreedCars& freed) {
  for (const int since : report.plugged_since) {
    for (Eigen::Index k = 0; k < freed.mean.cols(); ++k) {
      const auto minutes = static_cast<double>((k + 1) * slot);
      const double ends = share_that_ends(session_quantiles, minute - since, minutes);
      freed.mean(report.region, k) += ends;
      freed.variance(report.region, k) += ends * (1.0 - ends);
    }
  }
}

/// Cars that come free by each slot's end where passengers to come get out, N x K, if all of these are served.
Eigen::MatrixXd getting_out(const PlanningData& data, Eigen::Index slots, const std::vector<TripShare>& trips,
                            const BalancingParameters& parameters) {
  const CumulativeDemand demand(data);
  const Eigen::VectorXd fit = share_fit(data);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(data.km.rows(), slots);
  for (const auto& [from, to, share] : trips) {
    const double later = parameters.flow_pickup + std::ceil(data.minutes(from, to));
    for (Eigen::Index k = 0; k < slots; ++k) {
      const double minutes = static_cast<double>((k + 1) * parameters.flow_slot) - later;
      out(to, k) += minutes >= 0.0 ? share * fit(to) * demand.within(minutes, from) : 0.0;
    }
  }
  return out;
}

/// Share of the passengers to come that is served: with  s  of them,  s wanted <= cars + s again,  where `cars` are
/// those that come free without them and `again` those that are free again after serving all.
double share_served(double wanted, double cars, double again, double most) {
  return wanted > again ? std::min(most, cars / (wanted - again)) : most;
}

}  // namespace

Eigen::VectorXd share_fit(const PlanningData& data) {
  return 1.0 - data.transitions.front().vacant_to_low_battery.rowwise().sum().array();
}

int slots_at(const DayClock& clock, int minute, const BalancingParameters& parameters) {
  return std::clamp((clock.minutes() - minute) / parameters.flow_slot, 1, parameters.flow_slots);
}

FreedCars freed_cars(const PlanningData& data, const std::vector<Report>& reports, int minute, int slots,
                     const std::vector<double>& session_quantiles, const std::vector<TripShare>& trips,
                     const BalancingParameters& parameters) {
  const Eigen::Index n = data.km.rows();
  const Eigen::VectorXd fit = share_fit(data);
  FreedCars freed{Eigen::MatrixXd::Zero(n, slots), Eigen::MatrixXd::Zero(n, slots)};
  for (const Report& report : reports) {
    add_under_way(report, minute, parameters.flow_slot, fit(report.region), freed);
    add_plugged(report, minute, parameters.flow_slot, session_quantiles, freed);
  }
  const CumulativeDemand demand(data);
  double wanted = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    wanted += demand.within(slots * parameters.flow_slot, i);
  }
  const Eigen::MatrixXd all_served = getting_out(data, slots, trips, parameters);
  const double cars = data.state.vacant.sum() + freed.mean.rightCols(1).sum();
  const double share = share_served(wanted, cars, all_served.rightCols(1).sum(), parameters.flow_served);
  freed.mean += share * all_served;
  freed.variance += share * all_served;
  return freed;
}

}  // namespace evbal

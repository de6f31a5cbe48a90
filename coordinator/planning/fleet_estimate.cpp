#include "coordinator/planning/fleet_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evbal {
namespace {

int rounded(double vehicles) {
  return static_cast<int>(std::lround(std::max(0.0, vehicles)));
}

double count_of(const Report& report, Errand errand) {
  double vehicles = 0.0;
  for (const UnderWay& cars : report.bound) {
    vehicles += cars.errand == errand ? cars.count : 0;
  }
  return vehicles;
}

}  // namespace

FleetEstimate::FleetEstimate(EstimateModel model) : model_(std::move(model)) {
  const Eigen::Index n = model_.points.size();
  vacant_ = occupied_ = low_battery_ = plugged_ = variance_ = Eigen::VectorXd::Zero(n);
  last_.resize(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    last_[static_cast<std::size_t>(i)].region = static_cast<std::int32_t>(i);
    last_[static_cast<std::size_t>(i)].points = rounded(model_.points(i));
  }
}

void FleetEstimate::advance(int minute, const std::vector<Move>& moves, const Transitions& transitions) {
  const double passed = minute - minute_;
  const double share = std::min(1.0, passed / model_.step_minutes);
  set_off(moves);
  arrive(minute);
  const Eigen::VectorXd stay = transitions.vacant_to_vacant.transpose() * vacant_;
  const Eigen::VectorXd dropped = transitions.occupied_to_vacant.transpose() * occupied_;
  const Eigen::VectorXd picked = transitions.vacant_to_occupied.transpose() * vacant_;
  const Eigen::VectorXd ridden = transitions.occupied_to_occupied.transpose() * occupied_;
  const Eigen::VectorXd run_low = transitions.vacant_to_low_battery.transpose() * vacant_;
  const Eigen::VectorXd charged = std::min(1.0, passed / model_.mean_session_minutes) * plugged_;
  variance_ += share * (vacant_ + stay + dropped) + charged;
  vacant_ += share * (stay + dropped - vacant_) + charged;
  occupied_ += share * (picked + ridden - occupied_);
  low_battery_ += share * run_low;
  plugged_ -= charged;
  for (Eigen::Index i = 0; i < plugged_.size(); ++i) {
    const double free = std::max(0.0, last_[static_cast<std::size_t>(i)].points - plugged_(i));
    const double plug_in = std::min(low_battery_(i), free);
    low_battery_(i) -= plug_in;
    plugged_(i) += plug_in;
  }
  minute_ = minute;
}

void FleetEstimate::set_off(const std::vector<Move>& moves) {
  for (const Move& move : moves) {
    const bool tops_up = move.errand == Errand::charge && move.from == move.to;
    Eigen::VectorXd& from = move.errand == Errand::rebalance || tops_up ? vacant_ : low_battery_;
    const double sent = std::min<double>(move.count, from(move.from));
    from(move.from) -= sent;
    if (tops_up) {
      low_battery_(move.to) += sent;
    } else if (const int whole = rounded(sent); whole > 0) {
      const int arrives = minute_ + static_cast<int>(std::ceil(model_.minutes(move.from, move.to)));
      last_[static_cast<std::size_t>(move.to)].bound.push_back({move.to, arrives, move.errand, whole});
    }
  }
}

/// Empty cars that are due come in; those with passengers are the transitions' part.
void FleetEstimate::arrive(int minute) {
  for (Report& report : last_) {
    for (const UnderWay& cars : report.bound) {
      if (cars.minute < minute && cars.errand != Errand::passenger) {
        (cars.errand == Errand::charge ? low_battery_ : vacant_)(report.region) += cars.count;
      }
    }
    std::erase_if(report.bound, [&](const UnderWay& cars) { return cars.minute < minute; });
  }
}

std::vector<Report> FleetEstimate::settle(int tick, const std::vector<std::optional<Report>>& good) {
  std::vector<Report> reports;
  reports.reserve(good.size());
  for (std::size_t i = 0; i < good.size(); ++i) {
    if (good[i]) {
      believe(*good[i]);
    }
    reports.push_back(good[i] ? *good[i] : estimated(tick, static_cast<int>(i)));
  }
  return reports;
}

void FleetEstimate::believe(const Report& report) {
  const int i = report.region;
  vacant_(i) = report.vacant;
  occupied_(i) = count_of(report, Errand::passenger);
  low_battery_(i) = report.low_battery;
  plugged_(i) = report.plugged;
  variance_(i) = 0.0;
  last_[static_cast<std::size_t>(i)] = report;
}

Report FleetEstimate::estimated(int tick, int region) const {
  Report report = last_[static_cast<std::size_t>(region)];
  report.tick = tick;
  report.region = region;
  report.demand = report.completions = 0;
  report.vacant = rounded(vacant_(region));
  report.chargeable = std::min(report.chargeable, report.vacant);
  report.low_battery = rounded(low_battery_(region));
  report.reach_m.resize(std::min<std::size_t>(report.reach_m.size(), static_cast<std::size_t>(report.low_battery)));
  report.plugged = std::min(rounded(plugged_(region)), report.points);
  // Who has been plugged in longest leaves first; who came since is taken to have come now.
  auto& since = report.plugged_since;
  const auto plugged = static_cast<std::size_t>(report.plugged);
  since.erase(since.begin(), since.end() - static_cast<std::ptrdiff_t>(std::min(plugged, since.size())));
  since.resize(plugged, minute_);
  if (const int more = rounded(occupied_(region) - count_of(report, Errand::passenger)); more > 0) {
    const int arrives = minute_ + static_cast<int>(model_.step_minutes / 2.0);
    report.bound.push_back({region, arrives, Errand::passenger, more});
  }
  return report;
}

}  // namespace evbal

#include "coordinator/balancing/heuristics.hpp"

#include "coordinator/balancing/arcs.hpp"
#include "coordinator/balancing/send_limits.hpp"
#include "coordinator/balancing/top_up.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace evbal {
namespace {

Dispatch empty_dispatch(const PlanningData& data) {
  const auto steps = static_cast<std::size_t>(data.points.cols());
  return {.vacant = std::vector<std::vector<Flow>>(steps), .low_battery = std::vector<std::vector<Flow>>(steps)};
}

std::vector<bool> working_stations(const PlanningData& data) {
  std::vector<bool> station;
  for (const double points : data.points.col(0)) {
    station.push_back(points > 0.0);
  }
  return station;
}

void nearest_shortage_first(const BalancingParameters& parameters, const PlanningData& data, Dispatch& dispatch) {
  // missing_i = min(1, sum S / sum r_hat) r_hat_i - S_i, whole cars: where there is not enough, everybody has a fair
  // share
  const auto regions = data.km.rows();
  const Eigen::VectorXd demand = data.demand.mean.head(regions).cwiseMax(0.0) + data.state.waiting;
  const Eigen::VectorXd supply = data.state.vacant + data.state.arriving_vacant.col(0);
  const double share = std::min(1.0, supply.sum() / std::max(1.0, demand.sum()));
  const Eigen::VectorXd missing = (share * demand - supply).array().round();
  Eigen::VectorXd lacking = missing.cwiseMax(0.0);
  Eigen::VectorXd spare = (-missing).cwiseMax(0.0).cwiseMin(data.state.vacant.array().floor().matrix());
  // Only solvers need few arcs.
  auto arcs = vacant_arcs(data.km, parameters.m1, static_cast<int>(regions));
  std::ranges::stable_sort(arcs, {}, &Arc::km);
  auto& flows = dispatch.vacant.front();
  for (const auto& arc : arcs) {
    const double sent = std::min(spare(arc.from), lacking(arc.to));
    if (sent > 0.0) {
      flows.push_back({arc.from, arc.to, sent});
      spare(arc.from) -= sent;
      lacking(arc.to) -= sent;
    }
  }
  std::ranges::sort(flows, {}, [](const Flow& flow) { return std::pair(flow.from, flow.to); });
  const Eigen::VectorXd top_up = top_up_room(data).cwiseMin(spare);
  for (int i = 0; i < regions; ++i) {
    if (top_up(i) > 0.0) {
      dispatch.top_up.push_back({i, i, top_up(i)});
    }
  }
}

// Expected minutes until a car that finds `ahead` cars in the queue of a region is plugged in.
double expected_wait(const PlanningData& data, int region, double ahead) {
  const double points = data.points(region, 0);
  const double turns = std::max(0.0, ahead + 1.0 - (points - data.state.plugged(region))) / points;
  return turns * data.mean_session_minutes;
}

std::vector<Flow> least_travel_and_wait(const BalancingParameters& parameters, const PlanningData& data) {
  const auto station = working_stations(data);
  const auto arcs = low_battery_arcs(data.km, station, parameters.m2, parameters.neighbours);
  Eigen::VectorXd queue = data.state.low_battery + data.state.arriving_low_battery.rowwise().sum();
  std::map<std::pair<int, int>, double> sent;
  for (int from = 0; from < data.km.rows(); ++from) {
    const double waiting = data.state.low_battery(from);
    const std::vector<double>& reach = data.state.reach[static_cast<std::size_t>(from)];
    for (std::size_t sent_before = 0; static_cast<double>(sent_before) < waiting; ++sent_before) {
      const double car = std::min(1.0, waiting - static_cast<double>(sent_before));
      const double farthest = sent_before < reach.size() ? reach[sent_before] : HUGE_VAL;
      queue(from) -= car;
      int best = from;
      double least = station[static_cast<std::size_t>(from)] ? expected_wait(data, from, queue(from)) : HUGE_VAL;
      for (const auto& arc : arcs) {
        if (arc.from == from && arc.km <= farthest) {
          const double minutes = data.minutes(from, arc.to) + expected_wait(data, arc.to, queue(arc.to));
          if (minutes < least) {
            least = minutes;
            best = arc.to;
          }
        }
      }
      queue(best) += car;
      if (best != from) {
        sent[{from, best}] += car;
      }
    }
  }
  std::vector<Flow> flows;
  flows.reserve(sent.size());
  for (const auto& [pair, amount] : sent) {
    flows.push_back({pair.first, pair.second, amount});
  }
  return flows;
}

}  // namespace

Dispatch plan_none(const PlanningData& data) {
  Dispatch dispatch = empty_dispatch(data);
  const auto station = working_stations(data);
  for (const auto& arc : low_battery_arcs(data.km, station, 0.0, 1)) {
    const double waiting = low_battery_reaching(data.state, arc.from, arc.km);
    if (waiting > 0.0 && !station[static_cast<std::size_t>(arc.from)]) {
      dispatch.low_battery.front().push_back({arc.from, arc.to, waiting});
    }
  }
  return dispatch;
}

Dispatch plan_greedy(const BalancingParameters& parameters, const PlanningData& data) {
  Dispatch dispatch = empty_dispatch(data);
  nearest_shortage_first(parameters, data, dispatch);
  dispatch.low_battery.front() = least_travel_and_wait(parameters, data);
  return dispatch;
}

}  // namespace evbal

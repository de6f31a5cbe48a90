#include "coordinator/filter/moves_made.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace evbal {
namespace {

constexpr int errands = 3;

/// Cars of an errand that were due to arrive before `minute`.
int due_before(const std::vector<UnderWay>& bound, Errand errand, int minute) {
  int cars = 0;
  for (const UnderWay& car : bound) {
    cars += car.errand == errand && car.minute < minute ? car.count : 0;
  }
  return cars;
}

}  // namespace

std::vector<std::vector<UnderWay>> bound_for(const Tick& tick, int regions) {
  std::vector<std::map<std::pair<int, Errand>, int>> counts(static_cast<std::size_t>(regions));
  for (const Arrival& car : tick.arrivals) {
    ++counts[static_cast<std::size_t>(car.region)][{car.minute, car.errand}];
  }
  for (const UnderWay& cars : tick.under_way) {
    counts[static_cast<std::size_t>(cars.region)][{cars.minute, cars.errand}] += cars.count;
  }
  std::vector<std::vector<UnderWay>> bound(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    for (const auto& [when, count] : counts[i]) {
      bound[i].push_back({static_cast<std::int32_t>(i), when.first, when.second, count});
    }
  }
  return bound;
}

int count_of(const std::vector<UnderWay>& bound, Errand errand) {
  int cars = 0;
  for (const UnderWay& car : bound) {
    cars += car.errand == errand ? car.count : 0;
  }
  return cars;
}

RoadTraffic traffic_since(const PlanMade& last, const std::vector<std::vector<UnderWay>>& now, int until,
                          const Eigen::MatrixXd& minutes) {
  const auto n = static_cast<Eigen::Index>(now.size());
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(n);
  RoadTraffic traffic{none, none, none, none, none, Eigen::VectorXi::Zero(n)};
  const auto arrived = [&](const Move& move) { return last.minute + minutes(move.from, move.to) < until; };
  const auto on_the_road = [&](const Move& move) { return move.from != move.to && !arrived(move); };
  const auto estimated = [&](const Move& move) { return last.estimated[static_cast<std::size_t>(move.from)]; };
  Eigen::MatrixXd missing = Eigen::MatrixXd::Zero(n, errands);
  Eigen::MatrixXd doubtful = missing;  // of those asked for
  for (const Move& move : last.moves) {
    missing(move.to, static_cast<int>(move.errand)) += on_the_road(move) ? move.count : 0;
    doubtful(move.to, static_cast<int>(move.errand)) += on_the_road(move) && estimated(move) ? move.count : 0;
  }
  for (Eigen::Index to = 0; to < n; ++to) {
    const auto& before = last.bound[static_cast<std::size_t>(to)];
    const auto& after = now[static_cast<std::size_t>(to)];
    for (const Errand errand : {Errand::passenger, Errand::rebalance, Errand::charge}) {
      // Where an agent is away, cars that are due wait on the road.
      const int came = due_before(before, errand, until) - due_before(after, errand, until);
      (errand == Errand::charge ? traffic.came_low : traffic.came_vacant)(to) += came;
      missing(to, static_cast<int>(errand)) -= count_of(after, errand) - count_of(before, errand) + came;
    }
  }
  const auto set_off = [&](const Move& move, double cars) {
    (move.errand == Errand::charge ? traffic.left_low : traffic.left_vacant)(move.from) += cars;
  };
  for (const Move& move : last.moves) {
    const int errand = static_cast<int>(move.errand);
    const double absent = std::max(0.0, missing(move.to, errand));
    if (move.from == move.to) {
      traffic.topped_up(move.from) += move.count;
    } else if (on_the_road(move) && estimated(move)) {
      set_off(move, move.count * (1.0 - std::min(1.0, absent / doubtful(move.to, errand))));
    } else if (on_the_road(move)) {
      set_off(move, move.count);
      const double unexplained = std::max(0.0, absent - doubtful(move.to, errand));
      traffic.may_stay(move.from) += std::min(move.count, static_cast<int>(unexplained));
    }
  }
  for (const Move& move : last.moves) {
    if (move.from != move.to && arrived(move)) {
      const bool charges = move.errand == Errand::charge;
      const double left = charges ? last.low_battery(move.from) - traffic.left_low(move.from)
                                  : last.vacant(move.from) - traffic.left_vacant(move.from);
      const double cars = std::clamp(left, 0.0, static_cast<double>(move.count));
      set_off(move, cars);
      (charges ? traffic.came_low : traffic.came_vacant)(move.to) += cars;
    }
  }
  return traffic;
}

}  // namespace evbal

#include "tools/samples/random_planning_data.hpp"

#include "common/random.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace evbal {
namespace {

Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns, const std::function<double()>& entry) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, entry);
}

MomentSet moment_set(RandomStream& random, const Eigen::VectorXd& mean, int rank) {
  MomentSet set;
  set.mean = mean;
  set.deviation = 0.1 + 0.4 * mean.array().sqrt();
  set.factors = matrix(mean.size(), rank, [&] { return 0.2 * random.normal(); });
  set.g1 = random.uniform(0.1, 0.5);
  set.g2 = random.uniform(1.0, 2.0);
  return set;
}

// 1 where a car gets to in a step, 0 elsewhere.
Eigen::ArrayXXd reachable(const Eigen::MatrixXd& km, int out_degree) {
  Eigen::ArrayXXd within = Eigen::ArrayXXd::Ones(km.rows(), km.cols());
  if (out_degree > 0 && out_degree + 1 < km.cols()) {
    for (Eigen::Index i = 0; i < km.rows(); ++i) {
      Eigen::VectorXd sorted = km.row(i).transpose();
      std::ranges::sort(sorted);
      within.row(i) = (km.row(i).array() <= sorted(out_degree)).cast<double>();
    }
  }
  return within;
}

Transitions transitions(RandomStream& random, const Eigen::ArrayXXd& within) {
  const auto regions = within.rows();
  const auto draw = [&]() -> Eigen::MatrixXd {
    return within * matrix(regions, regions, [&] { return std::pow(random.uniform(), 6); }).array();
  };
  Transitions move{draw(), draw(), 0.05 * draw(), draw(), draw()};
  move.vacant_to_vacant.diagonal().array() += 0.3 * static_cast<double>(regions);
  const Eigen::VectorXd vacant =
      (move.vacant_to_vacant + move.vacant_to_occupied + move.vacant_to_low_battery).rowwise().sum();
  const Eigen::VectorXd occupied = (move.occupied_to_vacant + move.occupied_to_occupied).rowwise().sum();
  for (auto* rows : {&move.vacant_to_vacant, &move.vacant_to_occupied, &move.vacant_to_low_battery}) {
    *rows = vacant.cwiseInverse().asDiagonal() * *rows;
  }
  for (auto* rows : {&move.occupied_to_vacant, &move.occupied_to_occupied}) {
    *rows = occupied.cwiseInverse().asDiagonal() * *rows;
  }
  return move;
}

}  // namespace

PlanningData random_planning_data(std::uint64_t seed, const DataShape& shape) {
  RandomStream random(seed, Purpose::synthetic_city, {});
  const int n = shape.regions;
  const auto count = [&](double mean) { return static_cast<double>(random.poisson(mean)); };
  PlanningData data;
  const double side = 1.6 * std::sqrt(n);
  const Eigen::MatrixXd place = matrix(n, 2, [&] { return random.uniform(0.0, side); });
  data.km = matrix(n, n, [] { return 0.0; });
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      data.km(i, j) = 0.5 + 1.3 * (place.row(i) - place.row(j)).norm();
    }
  }
  data.minutes = 2.0 * data.km.array() + 2.0;

  const double cars = shape.vehicles_per_region;
  data.state.vacant = matrix(n, 1, [&] { return count(cars * random.exponential(0.6)); });
  data.state.occupied = matrix(n, 1, [&] { return count(0.3 * cars); });
  data.state.low_battery = matrix(n, 1, [&] { return count(0.05 * cars); });
  data.state.waiting = matrix(n, 1, [&] { return count(0.05 * cars); });
  data.state.arriving_vacant = matrix(n, shape.tau, [&] { return count(0.03 * cars); });
  data.state.arriving_low_battery = matrix(n, shape.tau, [&] { return count(0.02 * cars); });
  data.state.chargeable = (shape.chargeable_share * data.state.vacant).array().floor();
  data.state.reach.resize(static_cast<std::size_t>(n));
  data.points = Eigen::MatrixXd::Zero(n, shape.tau);
  for (int i = 0; i < n; ++i) {
    if (shape.station_share > 0.0 && (i == 0 || random.uniform() < shape.station_share)) {
      data.points.row(i).setConstant(1.0 + count(0.2 * cars));
    }
  }
  data.state.plugged =
      data.points.col(0).unaryExpr([&](double points) { return std::floor(random.uniform() * (points + 1.0)); });

  const Eigen::VectorXd busy = matrix(n, 1, [&] { return shape.demand_scale * cars * random.exponential(1.0); });
  data.demand = moment_set(random, busy.replicate(shape.tau, 1), shape.rank);
  data.completions = moment_set(random, (0.5 * data.points.reshaped()).eval(), shape.rank);
  data.demand_samples = matrix(data.demand.mean.size(), 20, [&] { return random.uniform(0.5, 1.5); });
  data.demand_samples = data.demand.mean.asDiagonal() * data.demand_samples;
  const Eigen::MatrixXd free = data.points.colwise() - 0.7 * data.state.plugged;
  data.free_points = moment_set(random, free.reshaped(), shape.rank);
  data.state.dropoffs_due = 0.5 * data.state.occupied.replicate(1, shape.tau);
  data.turnover = {.demand = {.linear = {1.36, 1.58}, .quadratic = {0.014, 0.018}},
                   .phi = 0.6,
                   .same_step_dropoffs = matrix(n, n, [&] { return random.uniform(0.0, 0.8 / n); })};
  const Eigen::ArrayXXd within = reachable(data.km, shape.out_degree);
  for (int k = 0; k < shape.tau; ++k) {
    data.transitions.push_back(transitions(random, within));
  }
  constexpr int slots = 6;
  data.freed.mean.setZero(n, slots);
  for (int k = 0; k < slots; ++k) {
    const Eigen::VectorXd before = k > 0 ? Eigen::VectorXd(data.freed.mean.col(k - 1)) : Eigen::VectorXd::Zero(n);
    data.freed.mean.col(k) = before + matrix(n, 1, [&] { return random.uniform(0.0, 0.1 * cars); });
  }
  data.freed.variance = 0.5 * data.freed.mean;
  const auto worth = [&] { return random.uniform(0.0, 20.0); };
  data.worth.vacant = matrix(n, 1, worth);
  data.worth.serving = matrix(n, 1, worth);
  return data;
}

}  // namespace evbal

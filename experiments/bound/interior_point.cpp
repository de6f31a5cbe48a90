#include "experiments/bound/interior_point.hpp"

#include "experiments/bound/starting_point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evbal {
namespace {

constexpr int max_iterations = 200;
constexpr double step_share = 0.9995;        // of the way to the first column that would become negative
constexpr double inward = 0.1;               // share of the starting point where one begins near another solution
constexpr double conservation_error = 1e-6;  // of cars and passengers, relative, of a flow that counts

/// The linear program  min cost'x,  A x = b,  x >= 0  on its way to the optimum.
class InteriorPoint {
 public:
  InteriorPoint(const TimeNetwork& network, double price, const std::optional<PricedFlow>& before)
      : network_(network), columns_(columns_of(network)), equations_(network) {
    cost_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t i = 0; i < network.ways.size(); ++i) {
      cost_[static_cast<Eigen::Index>(i)] = network.ways[i].km;
    }
    const auto groups = static_cast<Eigen::Index>(network.groups.size());
    cost_.tail(groups).setConstant(price);
    b_.nodes = Eigen::Map<const Eigen::VectorXd>(network.cars.data(), network.nodes());
    b_.groups.resize(groups);
    for (Eigen::Index group = 0; group < groups; ++group) {
      b_.groups[group] = network.groups[static_cast<std::size_t>(group)].passengers;
    }
    at_ = starting_point(network, cost_);
    if (before) {
      at_.x = inward * at_.x + (1.0 - inward) * before->point.x;
      at_.y.nodes = inward * at_.y.nodes + (1.0 - inward) * before->point.y.nodes;
      at_.y.groups = inward * at_.y.groups + (1.0 - inward) * before->point.y.groups;
      at_.z = cost_ - transposed(columns_, at_.y);
    }
  }

  /// One step. False if the numbers do not allow another.
  bool advance() {
    const NetworkRows primal = minus(b_, times(at_.x));
    const Eigen::VectorXd dual = cost_ - transposed(columns_, at_.y) - at_.z;
    const Eigen::VectorXd weight = at_.x.cwiseQuotient(at_.z);
    if (!weight.allFinite() || !equations_.factor(weight)) {
      return false;
    }
    Eigen::VectorXd target = -at_.x.cwiseProduct(at_.z);
    Direction way = direction(primal, dual, weight, target);
    const double mu = at_.x.dot(at_.z) / static_cast<double>(at_.x.size());
    const double mu_ahead = (at_.x + longest(at_.x, way.x) * way.x).dot(at_.z + longest(at_.z, way.z) * way.z) /
                            static_cast<double>(at_.x.size());
    const double centring = std::pow(mu_ahead / mu, 3);
    target.array() += centring * mu - way.x.array() * way.z.array();
    way = direction(primal, dual, weight, target);
    const double step_x = step_share * longest(at_.x, way.x);
    const double step_z = step_share * longest(at_.z, way.z);
    at_.x += step_x * way.x;
    at_.z += step_z * way.z;
    at_.y.nodes += step_z * way.y.nodes;
    at_.y.groups += step_z * way.y.groups;
    return true;
  }

  /// What a car is worth at each node.
  std::vector<double> values() const {
    const Eigen::VectorXd values = (-at_.y.nodes).cwiseMax(0.0);
    return {values.begin(), values.end()};
  }

  double km() const {
    const auto ways = static_cast<Eigen::Index>(network_.ways.size());
    return cost_.head(ways).dot(at_.x.head(ways));
  }
  double lost() const { return at_.x.tail(b_.groups.size()).sum(); }
  const InnerPoint& point() const { return at_; }

  /// Whether cars and passengers are conserved.
  bool feasible() const {
    const NetworkRows error = minus(b_, times(at_.x));
    return error.nodes.lpNorm<1>() <= conservation_error * (1.0 + b_.nodes.lpNorm<1>()) &&
           error.groups.lpNorm<1>() <= conservation_error * (1.0 + b_.groups.lpNorm<1>());
  }

 private:
  struct Direction {
    Eigen::VectorXd x;
    Eigen::VectorXd z;
    NetworkRows y;
  };

  /// Newton's step towards  A x = b,  A'y + z = cost,  z dx + x dz = target.
  Direction direction(const NetworkRows& primal, const Eigen::VectorXd& dual, const Eigen::VectorXd& weight,
                      const Eigen::VectorXd& target) const {
    Direction way;
    const Eigen::VectorXd shift = weight.cwiseProduct(dual) - target.cwiseQuotient(at_.z);
    NetworkRows right = times(shift);
    right.nodes += primal.nodes;
    right.groups += primal.groups;
    way.y = equations_.solve(std::move(right));
    const Eigen::VectorXd change = transposed(columns_, way.y);
    way.x = weight.cwiseProduct(change) - shift;
    way.z = dual - change;
    return way;
  }

  /// How far, at most 1, a vector can go before an entry becomes negative.
  static double longest(const Eigen::VectorXd& from, const Eigen::VectorXd& way) {
    double length = 1.0;
    for (Eigen::Index i = 0; i < from.size(); ++i) {
      if (way[i] < 0.0) {
        length = std::min(length, -from[i] / way[i]);
      }
    }
    return length;
  }

  NetworkRows times(const Eigen::VectorXd& x) const {
    NetworkRows rows{Eigen::VectorXd::Zero(b_.nodes.size()), Eigen::VectorXd::Zero(b_.groups.size())};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto& [from, to, group] = columns_[i];
      const double value = x[static_cast<Eigen::Index>(i)];
      if (from >= 0) {
        rows.nodes[from] += value;
      }
      if (to >= 0) {
        rows.nodes[to] -= value;
      }
      if (group >= 0) {
        rows.groups[group] += value;
      }
    }
    return rows;
  }

  static NetworkRows minus(NetworkRows a, const NetworkRows& b) {
    a.nodes -= b.nodes;
    a.groups -= b.groups;
    return a;
  }

  const TimeNetwork& network_;
  std::vector<NetworkColumn> columns_;
  NormalEquations equations_;
  Eigen::VectorXd cost_;
  NetworkRows b_;
  InnerPoint at_;
};

}  // namespace

PricedFlow priced_flow(const TimeNetwork& network, double price, const std::optional<PricedFlow>& before,
                       const std::function<bool(const PricedFlow&)>& stop) {
  InteriorPoint point(network, price, before);
  PricedFlow flow;
  const auto look = [&] {
    flow.bound = std::max(flow.bound, lagrangian_bound(network, price, consistent_values(network, point.values())));
    flow.km = point.km();
    flow.lost = point.lost();
    const double cost = price * flow.lost + flow.km;
    flow.solved = point.feasible() && cost - flow.bound <= flow_gap * std::max(1.0, cost);
  };
  look();
  while (flow.iterations < max_iterations && !flow.solved && !stop(flow) && point.advance()) {
    ++flow.iterations;
    look();
  }
  flow.point = point.point();
  return flow;
}

}  // namespace evbal

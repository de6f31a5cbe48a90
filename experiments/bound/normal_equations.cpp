#include "experiments/bound/normal_equations.hpp"

#include <array>
#include <cstddef>
#include <utility>

// LAPACK's Cholesky factors of a band and the solution by them, as its Fortran names them; the last argument is the
// length of the text `uplo`.
extern "C" {
void dpbtrf_(const char* uplo, const int* n, const int* kd, double* ab, const int* ldab, int* info, std::size_t);
void dpbtrs_(const char* uplo, const int* n, const int* kd, const int* nrhs, const double* ab, const int* ldab,
             double* b, const int* ldb, int* info, std::size_t);
}

namespace evbal {
namespace {

constexpr double ridge = 1e-14;  // of the diagonal: rounding may not make it negative

}  // namespace

std::vector<NetworkColumn> columns_of(const TimeNetwork& network) {
  std::vector<NetworkColumn> columns;
  columns.reserve(network.ways.size() + network.trips.size() + network.groups.size());
  for (const Way& way : network.ways) {
    columns.push_back({way.from, way.to, -1});
  }
  for (int group = 0; group < static_cast<int>(network.groups.size()); ++group) {
    const PassengerGroup& of = network.groups[group];
    for (int i = of.first; i < of.first + of.trips; ++i) {
      columns.push_back({network.trips[i].from, network.trips[i].to, group});
    }
  }
  for (int group = 0; group < static_cast<int>(network.groups.size()); ++group) {
    columns.push_back({-1, -1, group});
  }
  return columns;
}

NormalEquations::NormalEquations(const TimeNetwork& network)
    : network_(network), band_(network.reach + 1, network.nodes()) {}

bool NormalEquations::factor(const Eigen::VectorXd& weight) {
  const auto ways = static_cast<Eigen::Index>(network_.ways.size());
  const auto groups = static_cast<Eigen::Index>(network_.groups.size());
  trip_weight_ = weight.segment(ways, weight.size() - ways - groups);
  group_weight_ = weight.tail(groups);
  band_.setZero();
  add_ways(weight);
  for (std::size_t group = 0; group < network_.groups.size(); ++group) {
    add_group(group);
  }
  for (double& diagonal : band_.row(0)) {
    diagonal = diagonal == 0.0 ? 1.0 : diagonal * (1.0 + ridge);  // 0 where no car can be
  }
  const int size = network_.nodes();
  const int height = static_cast<int>(band_.rows());
  int info = 0;
  dpbtrf_("L", &size, &network_.reach, band_.data(), &height, &info, 1);
  return info == 0;
}

void NormalEquations::add_ways(const Eigen::VectorXd& weight) {
  for (std::size_t i = 0; i < network_.ways.size(); ++i) {
    const Way& way = network_.ways[i];
    const double w = weight[static_cast<Eigen::Index>(i)];
    at(way.from, way.from) += w;
    if (way.to >= 0) {
      at(way.to, way.to) += w;
      at(way.from, way.to) -= w;
    }
  }
}

// With its own row eliminated a group leaves  sum over pairs (k, l) of w_k w_l / sum w (a_k - a_l)(a_k - a_l)', a being
// the columns' parts at nodes: a sum without differences of large numbers. Who is lost has no part at nodes.
void NormalEquations::add_group(std::size_t group) {
  const PassengerGroup& of = network_.groups[group];
  const double lost = group_weight_[static_cast<Eigen::Index>(group)];
  const double sum = lost + trip_weight_.segment(of.first, of.trips).sum();
  group_weight_[static_cast<Eigen::Index>(group)] = sum;
  for (int k = of.first; k < of.first + of.trips; ++k) {
    add_difference(network_.trips[k], {.from = -1, .to = -1}, trip_weight_[k] * lost / sum);
    for (int l = of.first; l < k; ++l) {
      add_difference(network_.trips[k], network_.trips[l], trip_weight_[k] * trip_weight_[l] / sum);
    }
  }
}

void NormalEquations::add_difference(const Way& one, const Way& other, double weight) {
  const std::array<std::pair<int, double>, 4> parts{
      {{one.from, 1.0}, {one.to, -1.0}, {other.from, -1.0}, {other.to, 1.0}}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const auto& [a, sign_a] = parts[i];
      const auto& [b, sign_b] = parts[j];
      if (a >= 0 && b >= 0) {
        at(a, b) += (i != j && a == b ? 2.0 : 1.0) * sign_a * sign_b * weight;
      }
    }
  }
}

NetworkRows NormalEquations::solve(NetworkRows b) const {
  const auto for_each_trip = [&](auto&& act) {
    for (std::size_t group = 0; group < network_.groups.size(); ++group) {
      const PassengerGroup& of = network_.groups[group];
      for (int i = of.first; i < of.first + of.trips; ++i) {
        act(static_cast<Eigen::Index>(group), network_.trips[i], trip_weight_[i]);
      }
    }
  };
  for_each_trip([&](Eigen::Index group, const Way& trip, double weight) {
    const double moved = weight * b.groups[group] / group_weight_[group];
    b.nodes[trip.from] -= moved;
    if (trip.to >= 0) {
      b.nodes[trip.to] += moved;
    }
  });
  const int size = network_.nodes();
  const int height = static_cast<int>(band_.rows());
  const int one = 1;
  int info = 0;
  dpbtrs_("L", &size, &network_.reach, &one, band_.data(), &height, b.nodes.data(), &size, &info, 1);
  for_each_trip([&](Eigen::Index group, const Way& trip, double weight) {
    b.groups[group] -= weight * (b.nodes[trip.from] - (trip.to < 0 ? 0.0 : b.nodes[trip.to]));
  });
  b.groups.array() /= group_weight_.array();
  return b;
}

}  // namespace evbal

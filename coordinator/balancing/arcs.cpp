#include "coordinator/balancing/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace evbal {
namespace {

using Pairs = std::set<std::pair<int, int>>;

// Targets of `from` that satisfy `allowed`, nearest first.
template <class Allowed>
std::vector<int> nearest_first(const Eigen::MatrixXd& km, int from, const Allowed& allowed) {
  std::vector<int> targets;
  for (int to = 0; to < km.cols(); ++to) {
    if (to != from && std::isfinite(km(from, to)) && allowed(to)) {
      targets.push_back(to);
    }
  }
  std::ranges::stable_sort(targets, {}, [&](int to) { return km(from, to); });
  return targets;
}

void insert_near(Pairs& pairs, const Eigen::MatrixXd& km, int from, const std::vector<int>& targets, double max_km,
                 int neighbours) {
  for (std::size_t rank = 0; rank < targets.size(); ++rank) {
    const int to = targets[rank];
    if (rank == 0 || (std::cmp_less(rank, neighbours) && km(from, to) < max_km)) {
      pairs.emplace(from, to);
    }
  }
}

std::vector<Arc> arcs_of(const Pairs& pairs, const Eigen::MatrixXd& km) {
  std::vector<Arc> arcs;
  for (const auto& [from, to] : pairs) {
    if (std::isfinite(km(from, to))) {
      arcs.push_back({from, to, km(from, to)});
    }
  }
  return arcs;
}

}  // namespace

std::vector<Arc> vacant_arcs(const Eigen::MatrixXd& km, double max_km, int neighbours) {
  Pairs pairs;
  for (int from = 0; from < km.rows(); ++from) {
    const auto targets = nearest_first(km, from, [](int) { return true; });
    insert_near(pairs, km, from, targets, max_km, neighbours);
    if (!targets.empty()) {
      pairs.emplace(targets.front(), from);
    }
  }
  return arcs_of(pairs, km);
}

std::vector<Arc> low_battery_arcs(const Eigen::MatrixXd& km, const std::vector<bool>& station, double max_km,
                                  int neighbours) {
  Pairs pairs;
  for (int from = 0; from < km.rows(); ++from) {
    const auto targets = nearest_first(km, from, [&](int to) { return station[static_cast<std::size_t>(to)]; });
    insert_near(pairs, km, from, targets, max_km, neighbours);
  }
  return arcs_of(pairs, km);
}

}  // namespace evbal

#include "experiments/study/statistics/front.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace evbal {

namespace {

void sort_by_cost(std::vector<FrontPoint>& front) {
  std::sort(front.begin(), front.end(), [](const FrontPoint& a, const FrontPoint& b) {
    return std::pair(a.cost, a.value) < std::pair(b.cost, b.value);
  });
}

/// Whether `middle` lies on or above the line from `left` to `right`.
bool is_above(const FrontPoint& left, const FrontPoint& middle, const FrontPoint& right) {
  return (middle.value - left.value) * (right.cost - left.cost) >=
         (right.value - left.value) * (middle.cost - left.cost);
}

}  // namespace

std::vector<FrontPoint> lower_hull(std::vector<FrontPoint> front) {
  sort_by_cost(front);
  std::vector<FrontPoint> hull;
  for (const FrontPoint& point : front) {
    if (!hull.empty() && point.value >= hull.back().value) {
      continue;
    }
    while (hull.size() >= 2 && is_above(hull[hull.size() - 2], hull.back(), point)) {
      hull.pop_back();
    }
    hull.push_back(point);
  }
  return hull;
}

std::vector<FrontPoint> least_sum(const std::vector<std::vector<FrontPoint>>& hulls) {
  FrontPoint corner;
  std::vector<FrontPoint> edges;
  for (const auto& hull : hulls) {
    corner.cost += hull.front().cost;
    corner.value += hull.front().value;
    for (std::size_t i = 1; i < hull.size(); ++i) {
      edges.push_back({hull[i].cost - hull[i - 1].cost, hull[i].value - hull[i - 1].value});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const FrontPoint& a, const FrontPoint& b) { return a.value * b.cost < b.value * a.cost; });
  std::vector<FrontPoint> sum{corner};
  for (const FrontPoint& edge : edges) {
    sum.push_back({sum.back().cost + edge.cost, sum.back().value + edge.value});
  }
  return sum;
}

std::optional<double> value_at(std::vector<FrontPoint> front, double cost) {
  sort_by_cost(front);
  const auto same_cost = [](const FrontPoint& a, const FrontPoint& b) { return a.cost == b.cost; };
  front.erase(std::unique(front.begin(), front.end(), same_cost), front.end());
  const auto above =
      std::find_if(front.begin(), front.end(), [cost](const FrontPoint& point) { return point.cost >= cost; });
  if (above == front.end() || (above == front.begin() && above->cost > cost)) {
    return std::nullopt;
  }
  if (above->cost == cost) {
    return above->value;
  }
  const auto below = std::prev(above);
  const double share = (cost - below->cost) / (above->cost - below->cost);
  return below->value + share * (above->value - below->value);
}

}  // namespace evbal

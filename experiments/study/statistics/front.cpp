#include "experiments/study/statistics/front.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace evbal {

namespace {

/// Whether `middle` lies on or above the line from `left` to `right`.
bool is_above(const FrontPoint& left, const FrontPoint& middle, const FrontPoint& right) {
  return (middle.value - left.value) * (right.cost - left.cost) >=
         (right.value - left.value) * (middle.cost - left.cost);
}

}  // namespace

std::vector<std::size_t> hull_corners(const std::vector<FrontPoint>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(points[a].cost, points[a].value) < std::pair(points[b].cost, points[b].value);
  });
  std::vector<std::size_t> corners;
  for (const std::size_t i : order) {
    if (!corners.empty() && points[i].value >= points[corners.back()].value) {
      continue;
    }
    while (corners.size() >= 2 && is_above(points[corners[corners.size() - 2]], points[corners.back()], points[i])) {
      corners.pop_back();
    }
    corners.push_back(i);
  }
  return corners;
}

std::vector<FrontPoint> lower_hull(const std::vector<FrontPoint>& points) {
  std::vector<FrontPoint> hull;
  for (const std::size_t corner : hull_corners(points)) {
    hull.push_back(points[corner]);
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

std::optional<double> value_at(const std::vector<FrontPoint>& front, double cost) {
  const auto above = std::lower_bound(front.begin(), front.end(), cost,
                                      [](const FrontPoint& point, double least) { return point.cost < least; });
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

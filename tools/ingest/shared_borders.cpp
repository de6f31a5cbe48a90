#include "tools/ingest/shared_borders.hpp"

#include "tools/ingest/partition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace evbal {
namespace {

using Ring = std::vector<Corner>;

/// Corners by squares of the plane.
class CornerGrid {
 public:
  CornerGrid(const LocalFrame& frame, double square) : frame_(frame), square_(square) {}

  void add(Corner corner) {
    const LocalPoint at = frame_.local(point_of(corner));
    squares_[{index(at.east), index(at.north)}].push_back({corner, at});
  }

  /// Hands over the corners in and around the box of two places.
  template <class Use>
  void for_each_around(LocalPoint a, LocalPoint b, double margin, Use use) const {
    const int north = index(std::max(a.north, b.north) + margin);
    for (int x = index(std::min(a.east, b.east) - margin); x <= index(std::max(a.east, b.east) + margin); ++x) {
      auto found = squares_.lower_bound({x, index(std::min(a.north, b.north) - margin)});
      for (; found != squares_.end() && found->first <= std::pair(x, north); ++found) {
        for (const auto& [corner, at] : found->second) {
          use(corner, at);
        }
      }
    }
  }

 private:
  int index(double metres) const { return static_cast<int>(std::floor(metres / square_)); }

  const LocalFrame& frame_;
  double square_;
  std::map<std::pair<int, int>, std::vector<std::pair<Corner, LocalPoint>>> squares_;
};

/// For each corner the one that stands for it: the nearest of those within tolerance that came before, else itself.
std::map<Corner, Corner> merged_corners(const std::vector<Zone>& zones, const LocalFrame& frame, double tolerance) {
  std::set<Corner> corners;
  for (const auto& zone : zones) {
    for (const auto& ring : zone.rings) {
      corners.insert(ring.begin(), ring.end());
    }
  }
  std::map<Corner, Corner> stands_for;
  CornerGrid kept(frame, std::max(tolerance, 1.0));
  for (const Corner corner : corners) {
    const LocalPoint at = frame.local(point_of(corner));
    Corner nearest = corner;
    double least = tolerance;
    kept.for_each_around(at, at, tolerance, [&](Corner other, LocalPoint place) {
      const double metres = distance(at, place);
      if (metres <= least) {
        least = metres;
        nearest = other;
      }
    });
    if (nearest == corner) {
      kept.add(corner);
    }
    stands_for.emplace(corner, nearest);
  }
  return stands_for;
}

/// The corners close to the edge from a to b, in the order in which it passes them.
std::vector<Corner> corners_on_edge(Corner a, Corner b, const CornerGrid& grid, const LocalFrame& frame,
                                    double tolerance) {
  const LocalPoint from = frame.local(point_of(a));
  const LocalPoint to = frame.local(point_of(b));
  const double dx = to.east - from.east;
  const double dy = to.north - from.north;
  std::vector<std::pair<double, Corner>> passed;
  grid.for_each_around(from, to, tolerance, [&](Corner corner, LocalPoint at) {
    const double along = ((at.east - from.east) * dx + (at.north - from.north) * dy) / (dx * dx + dy * dy);
    const LocalPoint foot{from.east + along * dx, from.north + along * dy};
    if (corner != a && corner != b && along > 0.0 && along < 1.0 && distance(at, foot) <= tolerance) {
      passed.emplace_back(along, corner);
    }
  });
  std::sort(passed.begin(), passed.end());
  std::vector<Corner> corners;
  corners.reserve(passed.size());
  for (const auto& [along, corner] : passed) {
    corners.push_back(corner);
  }
  return corners;
}

Ring with_merged_corners(const Ring& ring, const std::map<Corner, Corner>& stands_for) {
  Ring merged;
  for (const Corner corner : ring) {
    const Corner now = stands_for.at(corner);
    if (merged.empty() || merged.back() != now) {
      merged.push_back(now);
    }
  }
  while (merged.size() > 1 && merged.front() == merged.back()) {
    merged.pop_back();
  }
  return merged.size() < 3 ? ring : merged;
}

}  // namespace

std::vector<Zone> with_shared_borders(std::vector<Zone> zones, double tolerance_m) {
  constexpr double kSquare = 200.0;  // m
  const LocalFrame frame(zones.front().centre);
  const auto stands_for = merged_corners(zones, frame, tolerance_m);
  CornerGrid grid(frame, kSquare);
  for (const auto& [corner, now] : stands_for) {
    if (corner == now) {
      grid.add(corner);
    }
  }
  for (auto& zone : zones) {
    for (auto& ring : zone.rings) {
      const Ring merged = with_merged_corners(ring, stands_for);
      ring.clear();
      for (std::size_t i = 0; i < merged.size(); ++i) {
        const auto passed = corners_on_edge(merged[i], merged[(i + 1) % merged.size()], grid, frame, tolerance_m);
        ring.push_back(merged[i]);
        ring.insert(ring.end(), passed.begin(), passed.end());
      }
    }
  }
  return zones;
}

void connect_nearest(const std::vector<LocalPoint>& centres, std::vector<std::vector<int>>& neighbours) {
  const auto insert = [&](int at, int neighbour) {
    auto& list = neighbours[at];
    list.insert(std::lower_bound(list.begin(), list.end(), neighbour), neighbour);
  };
  const auto n = static_cast<int>(centres.size());
  const std::vector<bool> all(centres.size(), true);
  std::vector<bool> together(centres.size(), false);
  std::vector<std::pair<double, int>> nearest(centres.size(), {std::numeric_limits<double>::infinity(), -1});
  int next = 0;
  while (next < n) {
    // What hangs together with `next` joins those together, and may be nearer to the others than they were.
    const auto joining = reachable(neighbours, next, all);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; joining[i] && !together[i] && j < n; ++j) {
        nearest[j] = std::min(nearest[j], {distance(centres[i], centres[j]), i});
      }
    }
    for (int i = 0; i < n; ++i) {
      together[i] = together[i] || joining[i];
    }
    next = n;
    for (int j = 0; j < n; ++j) {
      next = !together[j] && (next == n || nearest[j].first < nearest[next].first) ? j : next;
    }
    if (next < n) {
      insert(next, nearest[next].second);
      insert(nearest[next].second, next);
    }
  }
}

}  // namespace evbal

#include "tools/ingest/partition.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

namespace evbal {
namespace {

constexpr double kShapePrice = 0.3;  // of roundness against balance
constexpr int kMaxPasses = 200;

/// Sums over a set of zones that tell how heavy and how round it is.
struct Sums {
  double weight = 0.0;
  double area = 0.0;
  double east = 0.0;  // area x centre
  double north = 0.0;
  double square = 0.0;  // area x |centre|^2, and each zone's own moment as a disc

  Sums operator+(const Sums& o) const {
    return {weight + o.weight, area + o.area, east + o.east, north + o.north, square + o.square};
  }
  Sums operator-(const Sums& o) const {
    return {weight - o.weight, area - o.area, east - o.east, north - o.north, square - o.square};
  }

  /// Second moment of area over that of a disc of the same area, less one: 0 for a disc.
  double shape() const {
    const double moment = square - (east * east + north * north) / area;
    return moment * 2.0 * std::numbers::pi / (area * area) - 1.0;
  }

  /// Squared relative error of the weight, and the shape.
  double penalty(double mean_weight) const {
    const double excess = mean_weight > 0.0 ? weight / mean_weight - 1.0 : 0.0;
    return excess * excess + kShapePrice * shape();
  }
};

Sums sums_of(const ZoneGraph& graph, int zone) {
  const double area = graph.area[zone];
  const LocalPoint at = graph.centre[zone];
  const double own = area * area / (2.0 * std::numbers::pi);
  return {graph.weight[zone], area, area * at.east, area * at.north,
          area * (at.east * at.east + at.north * at.north) + own};
}

/// Parts while they are merged; a part is named by one of its zones.
class Merging {
 public:
  explicit Merging(const ZoneGraph& graph) : part_(graph.weight.size()) {
    std::iota(part_.begin(), part_.end(), 0);
    for (std::size_t zone = 0; zone < part_.size(); ++zone) {
      sums_.push_back(sums_of(graph, static_cast<int>(zone)));
      neighbours_.emplace_back(graph.neighbours[zone].begin(), graph.neighbours[zone].end());
      left_.insert(static_cast<int>(zone));
    }
  }

  int left() const { return static_cast<int>(left_.size()); }

  void merge_lightest(double mean_weight) {
    const int light =
        *std::min_element(left_.begin(), left_.end(), [&](int a, int b) { return sums_[a].weight < sums_[b].weight; });
    const auto price = [&](int other) {
      const Sums both = sums_[light] + sums_[other];
      return both.weight / mean_weight + kShapePrice * both.shape();
    };
    assert(!neighbours_[light].empty());
    const int other = *std::min_element(neighbours_[light].begin(), neighbours_[light].end(),
                                        [&](int a, int b) { return price(a) < price(b); });
    join(light, other);
  }

  const std::vector<int>& part_of() const { return part_; }

 private:
  void join(int gone, int into) {
    sums_[into] = sums_[into] + sums_[gone];
    for (const int n : neighbours_[gone]) {
      neighbours_[n].erase(gone);
      if (n != into) {
        neighbours_[n].insert(into);
        neighbours_[into].insert(n);
      }
    }
    std::replace(part_.begin(), part_.end(), gone, into);
    left_.erase(gone);
  }

  std::vector<int> part_;
  std::vector<Sums> sums_;
  std::vector<std::set<int>> neighbours_;
  std::set<int> left_;
};

bool stays_connected(const ZoneGraph& graph, const std::vector<int>& part, int leaving) {
  std::vector<bool> member(part.size(), false);
  int start = -1;
  int count = 0;
  for (std::size_t zone = 0; zone < part.size(); ++zone) {
    if (part[zone] == part[leaving] && static_cast<int>(zone) != leaving) {
      member[zone] = true;
      start = static_cast<int>(zone);
      ++count;
    }
  }
  if (count == 0) {
    return false;
  }
  const auto reached = reachable(graph.neighbours, start, member);
  return std::count(reached.begin(), reached.end(), true) == count;
}

/// Moves the zone to the neighbouring part where that helps most; false if nowhere does.
bool improve_zone(const ZoneGraph& graph, int zone, double mean_weight, std::vector<int>& part,
                  std::vector<Sums>& sums) {
  constexpr double kWorthwhile = 1e-9;
  const int from = part[zone];
  const Sums own = sums_of(graph, zone);
  if (sums[from].area - own.area <= 0.0) {
    return false;
  }
  const double leaving = (sums[from] - own).penalty(mean_weight) - sums[from].penalty(mean_weight);
  int best = from;
  double best_change = -kWorthwhile;
  for (const int n : graph.neighbours[zone]) {
    const int to = part[n];
    if (to == from) {
      continue;
    }
    const double change = leaving + (sums[to] + own).penalty(mean_weight) - sums[to].penalty(mean_weight);
    if (change < best_change) {
      best_change = change;
      best = to;
    }
  }
  if (best == from || !stays_connected(graph, part, zone)) {
    return false;
  }
  sums[from] = sums[from] - own;
  sums[best] = sums[best] + own;
  part[zone] = best;
  return true;
}

}  // namespace

std::vector<bool> reachable(const std::vector<std::vector<int>>& neighbours, int start,
                            const std::vector<bool>& member) {
  std::vector<bool> reached(neighbours.size(), false);
  std::vector<int> open{start};
  reached[start] = true;
  while (!open.empty()) {
    const int zone = open.back();
    open.pop_back();
    for (const int n : neighbours[zone]) {
      if (member[n] && !reached[n]) {
        reached[n] = true;
        open.push_back(n);
      }
    }
  }
  return reached;
}

std::vector<int> partition(const ZoneGraph& graph, int parts) {
  const auto n = static_cast<int>(graph.weight.size());
  EVBAL_EXPECT(parts >= 1 && parts <= n, "from one part to one a zone");
  const double total = std::accumulate(graph.weight.begin(), graph.weight.end(), 0.0);
  const double mean_weight = total > 0.0 ? total / parts : 1.0;
  Merging merging(graph);
  while (merging.left() > parts) {
    merging.merge_lightest(mean_weight);
  }
  const std::set<int> names(merging.part_of().begin(), merging.part_of().end());
  std::vector<int> part;
  std::vector<Sums> sums(parts);
  for (int zone = 0; zone < n; ++zone) {
    part.push_back(static_cast<int>(std::distance(names.begin(), names.find(merging.part_of()[zone]))));
    sums[part[zone]] = sums[part[zone]] + sums_of(graph, zone);
  }
  bool moved = true;
  for (int pass = 0; moved && pass < kMaxPasses; ++pass) {
    moved = false;
    for (int zone = 0; zone < n; ++zone) {
      moved = improve_zone(graph, zone, mean_weight, part, sums) || moved;
    }
  }
  return part;
}

}  // namespace evbal

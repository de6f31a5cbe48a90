#include "tools/ingest/outlines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace evbal {
namespace {

constexpr double kSmallestRing = 0.01;  // of the region's largest ring
constexpr int kNoRegion = -1;

using Ring = std::vector<Corner>;
using Edge = std::pair<Corner, Corner>;

/// The edges of each region's zones.
std::vector<std::vector<Edge>> edges_of(const std::vector<Zone>& zones, std::span<const int> region_of, int regions) {
  std::vector<std::vector<Edge>> edges(regions);
  for (std::size_t z = 0; z < zones.size(); ++z) {
    if (region_of[z] == kNoRegion) {
      continue;
    }
    for (const auto& ring : zones[z].rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        edges[region_of[z]].emplace_back(ring[i], ring[(i + 1) % ring.size()]);
      }
    }
  }
  return edges;
}

/// The region to the left of each directed edge.
using Owners = std::map<Edge, int>;

Owners edge_owners(const std::vector<std::vector<Edge>>& edges) {
  Owners owners;
  for (std::size_t region = 0; region < edges.size(); ++region) {
    for (const Edge& edge : edges[region]) {
      owners.emplace(edge, static_cast<int>(region));
    }
  }
  return owners;
}

/// The region to the right of an edge.
int across(const Owners& owners, Corner a, Corner b) {
  const auto other = owners.find({b, a});
  return other == owners.end() ? kNoRegion : other->second;
}

/// Chains a region's border into rings: the edges of its zones that no other of its zones has the other way round.
std::vector<Ring> border_rings(const std::vector<Edge>& edges) {
  std::map<Edge, int> times;  // zones may overlap
  for (const auto& [a, b] : edges) {
    const auto back = times.find({b, a});
    if (back == times.end()) {
      ++times[{a, b}];
    } else if (--back->second == 0) {
      times.erase(back);
    }
  }
  std::map<Corner, std::multiset<Corner>> onward;
  for (const auto& [edge, count] : times) {
    for (int k = 0; k < count; ++k) {
      onward[edge.first].insert(edge.second);
    }
  }
  std::vector<Ring> rings;
  while (!onward.empty()) {
    Ring ring;
    Corner at = onward.begin()->first;
    for (auto next = onward.find(at); next != onward.end(); next = onward.find(at)) {
      ring.push_back(at);
      at = *next->second.begin();
      next->second.erase(next->second.begin());
      if (next->second.empty()) {
        onward.erase(next);
      }
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

/// Keeps outer rings that are large enough; all if there is no outer one, for zones drawn wrongly.
void drop_slivers(std::vector<Ring>& rings) {
  double largest = 0.0;
  for (const auto& ring : rings) {
    largest = std::max(largest, signed_area(ring));
  }
  if (largest == 0.0) {
    return;
  }
  std::erase_if(rings, [&](const Ring& ring) { return signed_area(ring) < kSmallestRing * largest; });
}

double distance_to_segment(LocalPoint p, LocalPoint a, LocalPoint b) {
  const double dx = b.east - a.east;
  const double dy = b.north - a.north;
  const double square = dx * dx + dy * dy;
  const double along = square > 0.0 ? ((p.east - a.east) * dx + (p.north - a.north) * dy) / square : 0.0;
  const double t = std::clamp(along, 0.0, 1.0);
  return distance(p, {a.east + t * dx, a.north + t * dy});
}

/// Douglas-Peucker on line[first..last]: marks in `keep` the corners between that are needed.
void mark_needed(const std::vector<LocalPoint>& line, std::size_t first, std::size_t last, double tolerance,
                 std::vector<bool>& keep) {
  double furthest = 0.0;
  std::size_t at = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double metres = distance_to_segment(line[i], line[first], line[last]);
    if (metres > furthest) {
      furthest = metres;
      at = i;
    }
  }
  if (furthest > tolerance) {
    keep[at] = true;
    mark_needed(line, first, at, tolerance, keep);
    mark_needed(line, at, last, tolerance, keep);
  }
}

/// Puts a corner first at which the border passes from one neighbour to the next, so that arcs start alike for both;
/// the smallest corner if there is but one neighbour.
void start_at_junction(const Owners& owners, Ring& ring) {
  const std::size_t n = ring.size();
  std::size_t start = static_cast<std::size_t>(std::min_element(ring.begin(), ring.end()) - ring.begin());
  for (std::size_t i = 0; i < n; ++i) {
    if (across(owners, ring[(i + n - 1) % n], ring[i]) != across(owners, ring[i], ring[(i + 1) % n])) {
      start = i;
      break;
    }
  }
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
}

std::vector<LatLon> simplified(const Owners& owners, Ring ring, const LocalFrame& frame, double tolerance) {
  start_at_junction(owners, ring);
  std::vector<LatLon> points = points_of(ring);
  const std::vector<LatLon> full = points;
  ring.push_back(ring.front());
  points.push_back(points.front());
  std::vector<LocalPoint> line;
  std::transform(points.begin(), points.end(), std::back_inserter(line),
                 [&](LatLon point) { return frame.local(point); });
  std::vector<bool> keep(ring.size(), false);
  std::size_t first = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const bool last_edge = i + 1 == ring.size();
    if (last_edge || across(owners, ring[i - 1], ring[i]) != across(owners, ring[i], ring[i + 1])) {
      keep[i] = true;
      mark_needed(line, first, i, tolerance, keep);
      first = i;
    }
  }
  std::vector<LatLon> needed;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (keep[i]) {
      needed.push_back(points[i]);
    }
  }
  return needed.size() < 3 ? full : needed;
}

}  // namespace

std::vector<Outline> merged_outlines(const std::vector<Zone>& zones, std::span<const int> region_of, int regions,
                                     double tolerance_m) {
  const auto edges = edges_of(zones, region_of, regions);
  const Owners owners = edge_owners(edges);
  const LocalFrame frame(zones.front().centre);
  std::vector<Outline> outlines;
  for (int region = 0; region < regions; ++region) {
    auto rings = border_rings(edges[region]);
    drop_slivers(rings);
    Outline& outline = outlines.emplace_back();
    for (auto& ring : rings) {
      outline.push_back(simplified(owners, std::move(ring), frame, tolerance_m));
    }
  }
  return outlines;
}

}  // namespace evbal

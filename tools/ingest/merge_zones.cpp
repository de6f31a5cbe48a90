#include "tools/ingest/merge_zones.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "tools/ingest/partition.hpp"
#include "tools/ingest/shared_borders.hpp"
#include "tools/records/dropped.hpp"

#include <algorithm>
#include <numeric>

namespace evbal {
namespace {

/// Zones that hang together by their edges, and share none with others.
struct Island {
  std::vector<int> zones;  ///< ascending
  double ends = 0.0;       ///< of trips
};

/// The zones that are `near` as islands, the busiest first.
std::vector<Island> islands_of(const ZoneWeights& weights, const std::vector<std::vector<int>>& neighbours,
                               const std::vector<bool>& near) {
  std::vector<Island> islands;
  std::vector<bool> left = near;
  for (std::size_t start = 0; start < left.size(); ++start) {
    if (!left[start]) {
      continue;
    }
    Island& island = islands.emplace_back();
    const auto reached = reachable(neighbours, static_cast<int>(start), near);
    for (std::size_t z = start; z < left.size(); ++z) {
      if (reached[z]) {
        left[z] = false;
        island.zones.push_back(static_cast<int>(z));
        island.ends += weights.ends[z];
      }
    }
  }
  std::stable_sort(islands.begin(), islands.end(), [](const Island& a, const Island& b) { return a.ends > b.ends; });
  return islands;
}

/// "3 (first: `12`), trip ends: 40".
std::string summary(const Island& group, const std::vector<Zone>& zones) {
  return std::to_string(group.zones.size()) + " (first: " + shown(zones[group.zones.front()].name) +
         "), trip ends: " + decimal(group.ends) + "\n";
}

/// The zones within reach that are not apart; `left_out` tells of the others.
std::vector<bool> zones_near(const std::vector<Zone>& zones, const ZoneWeights& weights, double reach_km,
                             const std::vector<int>& apart, std::string& left_out) {
  const LocalFrame frame(weights.mean_pickup);
  std::vector<bool> near;
  Island far;
  for (int z = 0; z < static_cast<int>(zones.size()); ++z) {
    const bool taken = std::find(apart.begin(), apart.end(), z) != apart.end();
    near.push_back(!taken && distance(frame.local(zones[z].centre), {}) <= 1000.0 * reach_km);
    if (!taken && !near.back()) {
      far.zones.push_back(z);
      far.ends += weights.ends[z];
    }
  }
  left_out += far.zones.empty() ? "" : "  dropped, zones out of reach: " + summary(far, zones);
  return near;
}

/// The zones of the islands that count, ascending; `left_out` tells of the others.
std::vector<int> zones_in_city(const std::vector<Zone>& zones, const std::vector<Island>& islands,
                               std::string& left_out) {
  constexpr double kNegligible = 0.01;     // of the trip ends
  constexpr std::size_t kMostListed = 10;  // islands
  double left = 0.0;
  for (const Island& island : islands) {
    left += island.ends;
  }
  const double negligible = kNegligible * left;
  std::vector<int> city;
  std::size_t listed = 0;
  Island others;  // beyond the list
  for (const Island& island : islands) {
    if (city.empty() || left >= negligible) {
      city.insert(city.end(), island.zones.begin(), island.zones.end());
    } else if (listed++ < kMostListed) {
      left_out += "  dropped, zones on an island of few trips: " + summary(island, zones);
    } else {
      others.zones.insert(others.zones.end(), island.zones.begin(), island.zones.end());
      others.ends += island.ends;
    }
    left -= island.ends;
  }
  left_out += others.zones.empty() ? "" : "  dropped, zones on more such islands: " + summary(others, zones);
  std::sort(city.begin(), city.end());
  return city;
}

std::vector<int> zones_apart(const std::vector<Zone>& zones, const CityNotes& notes) {
  const std::vector<Outline> outlines = outlines_of(zones);
  const OutlineMap map(outlines);
  std::vector<int> apart;
  for (const auto& place : notes.apart) {
    const auto zone = map.containing(place.place);
    if (!zone) {
      throw bad_input("place apart `" + place.name + "`, at " + decimal(place.place.lat) + ", " +
                      decimal(place.place.lon) + ", lies in no zone");
    }
    apart.push_back(*zone);
  }
  return apart;
}

/// The chosen zones as a graph of their own.
ZoneGraph graph_of(const std::vector<Zone>& zones, const std::vector<double>& weights, LatLon middle,
                   const std::vector<int>& chosen, const std::vector<std::vector<int>>& neighbours) {
  std::vector<int> position(zones.size(), -1);
  for (std::size_t p = 0; p < chosen.size(); ++p) {
    position[chosen[p]] = static_cast<int>(p);
  }
  const LocalFrame frame(middle);
  ZoneGraph graph;
  for (const int z : chosen) {
    graph.weight.push_back(weights[z]);
    graph.area.push_back(std::max(1.0, zones[z].area_m2));
    graph.centre.push_back(frame.local(zones[z].centre));
    auto& near = graph.neighbours.emplace_back();
    for (const int n : neighbours[z]) {
      if (position[n] >= 0) {
        near.push_back(position[n]);
      }
    }
  }
  return graph;
}

/// Parts renumbered from north to south by their centre of area.
std::vector<int> north_to_south(const ZoneGraph& graph, const std::vector<int>& part, int parts) {
  std::vector<double> area(parts, 0.0);
  std::vector<double> north(parts, 0.0);
  for (std::size_t p = 0; p < part.size(); ++p) {
    area[part[p]] += graph.area[p];
    north[part[p]] += graph.area[p] * graph.centre[p].north;
  }
  std::vector<int> order(parts);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return north[a] / area[a] > north[b] / area[b]; });
  std::vector<int> rank(parts);
  for (int r = 0; r < parts; ++r) {
    rank[order[r]] = r;
  }
  std::vector<int> renumbered;
  renumbered.reserve(part.size());
  for (const int p : part) {
    renumbered.push_back(rank[p]);
  }
  return renumbered;
}

/// "r01", "r02", ...
std::vector<std::string> numbered_names(int parts) {
  std::vector<std::string> names;
  for (int r = 1; r <= parts; ++r) {
    names.push_back((r < 10 ? "r0" : "r") + std::to_string(r));
  }
  return names;
}

}  // namespace

MergedZones merge_zones(const std::vector<Zone>& zones, const ZoneWeights& weights, const CityNotes& notes,
                        int regions) {
  const std::vector<int> apart = zones_apart(zones, notes);
  const auto neighbours = neighbours_of(zones);
  std::string left_out;
  const auto near = zones_near(zones, weights, notes.reach_km, apart, left_out);
  const std::vector<int> chosen = zones_in_city(zones, islands_of(weights, neighbours, near), left_out);
  const int parts = regions - static_cast<int>(apart.size());
  if (parts < 1 || static_cast<int>(chosen.size()) < parts) {
    throw with_report(bad_input("cannot make " + std::to_string(regions) + " regions, " + std::to_string(apart.size()) +
                                " of them apart, of " + std::to_string(chosen.size()) + " zones within reach"),
                      left_out);
  }
  ZoneGraph graph = graph_of(zones, weights.pickups, weights.mean_pickup, chosen, neighbours);
  connect_nearest(graph.centre, graph.neighbours);
  const std::vector<int> part = north_to_south(graph, partition(graph, parts), parts);

  MergedZones merged{std::vector<int>(zones.size(), -1), {}, std::move(left_out)};
  for (std::size_t p = 0; p < chosen.size(); ++p) {
    merged.region_of[chosen[p]] = part[p];
  }
  merged.names = numbered_names(parts);
  for (std::size_t a = 0; a < apart.size(); ++a) {
    merged.region_of[apart[a]] = parts + static_cast<int>(a);
    merged.names.push_back(notes.apart[a].name);
  }
  return merged;
}

MergedZones merge_all_zones(const std::vector<Zone>& zones, int regions) {
  const auto n = static_cast<int>(zones.size());
  if (regions < 1 || n < regions) {
    throw bad_input("cannot make " + std::to_string(regions) + " regions of " + std::to_string(n) + " zones");
  }
  std::vector<double> weights;
  std::transform(zones.begin(), zones.end(), std::back_inserter(weights), [](const Zone& zone) { return zone.weight; });
  std::vector<int> all(zones.size());
  std::iota(all.begin(), all.end(), 0);
  ZoneGraph graph = graph_of(zones, weights, zones.front().centre, all, neighbours_of(zones));
  connect_nearest(graph.centre, graph.neighbours);
  return {north_to_south(graph, partition(graph, regions), regions), numbered_names(regions), {}};
}

}  // namespace evbal

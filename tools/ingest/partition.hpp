#pragma once

#include "agents/world/geometry.hpp"

#include <vector>

namespace evbal {

/// Zones as a graph: what partition() looks at.
struct ZoneGraph {
  std::vector<double> weight;                ///< what shall be balanced, not negative
  std::vector<double> area;                  ///< m2, positive
  std::vector<LocalPoint> centre;            ///< of each zone
  std::vector<std::vector<int>> neighbours;  ///< symmetric, ascending
};

/// Merges zones into `parts` connected, compact parts of about equal weight: the lightest part joins the neighbour
/// with which it is lightest and roundest until `parts` are left, then single zones change sides while that helps.
/// Returns each zone's part, 0..parts-1. Deterministic. The graph must be connected and have at least `parts` zones.
std::vector<int> partition(const ZoneGraph& graph, int parts);

/// Zones that can be reached from `start` among those with `member[zone]`.
std::vector<bool> reachable(const std::vector<std::vector<int>>& neighbours, int start,
                            const std::vector<bool>& member);

}  // namespace evbal

#pragma once

#include "tools/ingest/zones.hpp"

#include <vector>

namespace evbal {

/// Zones whose borders run along each other within `tolerance_m`, drawn so that they share corners and edges exactly:
/// corners so close become one, and a corner so close to another zone's edge divides that edge. A ring that would
/// vanish stays as it was.
std::vector<Zone> with_shared_borders(std::vector<Zone> zones, double tolerance_m);

/// Connects the graph where it is not, as at islands: what is connected to the first zone gets an edge to the nearest
/// centre that is not, until all are. `neighbours` is symmetric and ascending, and stays so.
void connect_nearest(const std::vector<LocalPoint>& centres, std::vector<std::vector<int>>& neighbours);

}  // namespace evbal

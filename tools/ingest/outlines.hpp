#pragma once

#include "tools/ingest/zones.hpp"

#include <span>

namespace evbal {

/// By how much the borders of a pack's regions are simplified, in metres.
constexpr double outline_tolerance_m = 30.0;

/// Outer rings of the regions that zones are merged into: `region_of[z]` in 0..regions-1, or -1 for none. Inner edges
/// are dissolved; holes, and rings below 1 % of the region's largest, are left out. Borders are simplified to
/// `tolerance_m`, alike for both regions that share them.
std::vector<Outline> merged_outlines(const std::vector<Zone>& zones, std::span<const int> region_of, int regions,
                                     double tolerance_m);

}  // namespace evbal

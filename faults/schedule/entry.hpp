#pragma once

#include "faults/schedule/schedule.hpp"

#include <string>
#include <vector>

/// What every entry of a list of faults has, asked for or drawn.
namespace evbal {

/// A fault and the place in the file that asked for it.
struct PlacedFault {
  Fault fault;      ///< as drawn
  YamlValue where;  ///< where it was asked for, for messages
};

/// Reads the key `name`: letters, digits, `-`, `_` and `.`, so that it fits everywhere.
std::string read_name(YamlMap& map);

/// Regions with at least so many points, ascending.
std::vector<int> regions_with(const FaultContext& context, int min_points);

/// Reads a list of regions, ascending. Throws if one is out of range, given twice, or lacks the points that a fault
/// needs.
std::vector<int> read_regions(const YamlValue& value, const FaultContext& context, bool with_points);

}  // namespace evbal

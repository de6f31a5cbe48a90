#pragma once

#include "faults/schedule/fault_types.hpp"
#include "faults/schedule/quantity.hpp"
#include "faults/schedule/schedule.hpp"

#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// Regions to choose from, and how many are chosen; all of them without `pick`.
struct Target {
  std::vector<int> candidates;
  std::optional<Quantity> pick;
};

/// Repetitions by a Poisson process.
struct Arrivals {
  double per_hour = 0.0;
  int from = 0;  ///< minute after midnight
  int to = 0;
};

/// A factor, a number of points, or a fraction of them.
struct Magnitude {
  Quantity quantity;
  bool fraction = false;  ///< of a region's points
};

/// One entry of `faults` as asked for.
struct Request {
  std::string name;
  const FaultType* type = nullptr;
  Target target;
  std::optional<Quantity> start;  ///< minute after midnight; else arrivals
  Arrivals arrivals;
  Quantity duration;
  Quantity ramp;
  Magnitude magnitude;
  OnStart on_start = OnStart::drain;
  bool visible = true;
};

/// Throws Error{bad_input} with file, line and what would be right.
Request read_request(const YamlValue& entry, const Place& place);

}  // namespace evbal

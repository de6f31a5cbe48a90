#pragma once

#include "faults/schedule/fault_types.hpp"
#include "faults/schedule/quantity.hpp"
#include "faults/schedule/schedule.hpp"
#include "faults/schedule/target.hpp"

#include <optional>
#include <string>

namespace evbal {

/// Repetitions by a Poisson process.
struct Arrivals {
  double per_hour = 0.0;
  int from = 0;  ///< minute after midnight
  int to = 0;
};

/// How much of a fault there is, in the unit of its type, or the fraction of a region's points.
struct Magnitude {
  Quantity quantity;
  bool fraction = false;
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
  int to = no_region;
};

/// Throws Error{bad_input} with file, line and what would be right.
Request read_request(const YamlValue& entry, const FaultContext& context);

}  // namespace evbal

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
  double per_hour = 0.0;  ///< expected number
  int from = 0;           ///< minute after midnight
  int to = 0;             ///< minute after midnight, from which on none begins
};

/// How much of a fault there is, in the unit of its type, or the fraction of a region's points.
struct Magnitude {
  Quantity quantity;      ///< how much
  bool fraction = false;  ///< of what there is, rather than a number
};

/// One entry of `faults` as asked for.
struct Request {
  std::string name;                   ///< of the fault
  const FaultType* type = nullptr;    ///< what it is
  Target target;                      ///< what it acts on
  std::optional<Quantity> start;      ///< minute after midnight; else arrivals
  Arrivals arrivals;                  ///< how often it begins
  Quantity duration;                  ///< minutes
  Quantity ramp;                      ///< minutes
  Magnitude magnitude;                ///< how much
  OnStart on_start = OnStart::drain;  ///< cars at points that fail
  bool visible = true;                ///< whether reports and forecasters are told
  int to = no_region;                 ///< destination, of demand.shift
};

/// Throws Error{bad_input} with file, line and what would be right.
Request read_request(const YamlValue& entry, const FaultContext& context);

}  // namespace evbal

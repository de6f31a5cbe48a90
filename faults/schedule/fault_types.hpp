#pragma once

#include "agents/protocol/messages.hpp"
#include "faults/schedule/quantity.hpp"

#include <string>
#include <vector>

/// The table of fault types. A new type begins here:
/// - its name and keys: a row in fault_types.cpp, at the place of its EffectType;
/// - its EffectType: agents/protocol/messages.hpp (with the meaning of its magnitude) and agents/bus/evbal.idl;
/// - what it does, by family: the world in agents/region/region_faults.cpp, sensors in agents/region/sensors.cpp,
///   processes and the network in experiments/conductor/attendance.cpp, the solver in coordinator/planning;
/// - a row in docs/faults.md.
namespace evbal {

/// What a fault's target names.
enum class TargetKind {
  regions,
  stations,   ///< regions that have charging points
  sensors,    ///< regions, and a field of their reports
  processes,  ///< agents by their region, the coordinator or the injector
  hosts,      ///< regions, all that one of the scenario's hosts holds
  links,      ///< regions, whose way to and from the coordinator it is
  topics,     ///< likewise, and what is said there
  engine,     ///< the coordinator's; nothing to name
};

/// What a fault's magnitude measures.
enum class MagnitudeUnit {
  none,  ///< the fault has no more or less
  number,
  minutes,  ///< whole minutes, at least 1
  count,    ///< of `counted` things: a whole number
};

/// A type of fault: its name in a schedule, and which keys it has beside those of every fault.
struct FaultType {
  std::string name;                              ///< in a schedule
  EffectType effect = EffectType::demand_scale;  ///< what it does
  TargetKind target = TargetKind::regions;       ///< what its target names
  MagnitudeUnit unit = MagnitudeUnit::number;    ///< what its magnitude measures
  Range range{0.0, 0.0};                         ///< of the magnitude; points are limited by their region instead
  std::string counted{};                         ///< "points", "vehicles", "iterations"
  double neutral = 0.0;                          ///< the magnitude that changes nothing, from which a ramp rises
  bool ramp = false;                             ///< comes and goes gradually
  bool on_start = false;                         ///< cars at the points that fail: evict or drain
  bool to = false;                               ///< has a region as destination
  std::string magnitude = "magnitude";           ///< the key
  std::string duration = "duration";             ///< the key

  /// Whether its magnitude is a number of charging points.
  bool counts_points() const { return counted == "points"; }

  /// Whether it is to be said who is told: only of the world.
  bool may_be_invisible() const { return family_of(effect) == FaultFamily::world; }
};

/// All types, in the order of EffectType.
const std::vector<FaultType>& fault_types();

/// Names of fault_types(), in their order.
std::vector<std::string> fault_type_names();

/// The row of an effect.
const FaultType& fault_type(EffectType effect);

/// Largest factor on demand that a schedule may ask for.
constexpr double max_factor = 100.0;

/// The fields that a sensor measures, from ReportField::vacant on.
std::vector<std::string> report_field_words();

}  // namespace evbal

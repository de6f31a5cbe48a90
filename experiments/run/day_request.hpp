#pragma once

#include "common/yaml.hpp"

#include <optional>
#include <string>

namespace evbal {

/// What a day that goes on is asked to do.
enum class DayDeed {
  fault,     ///< a fault begins
  pause,     ///< it stands still
  go_on,     ///< it goes on
  tick,      ///< it plays one tick, then it stands still
  speed,     ///< it goes no faster than so
  kill,      ///< one of its processes is killed
  schedule,  ///< its faults are told
};

/// A request, read from a YAML map:
///
///     {do: fault, fault: {type: charger.outage, ...}}   as with_fault_by_hand takes it
///     {do: pause}   {do: go on}   {do: tick}   {do: schedule}
///     {do: speed, speed: 600}   {do: speed, speed: unlimited}
///     {do: kill, process: agent-3}
struct DayRequest {
  DayDeed deed = DayDeed::pause;     ///< `do`
  std::optional<YamlValue> fault{};  ///< of DayDeed::fault
  std::optional<double> speed{};     ///< of DayDeed::speed: simulated time by the wall's clock; none is unlimited
  std::string process{};             ///< of DayDeed::kill
};

/// Throws Error{bad_input} for what is no request.
DayRequest read_day_request(const std::string& text);

}  // namespace evbal

#pragma once

#include "faults/schedule/fault_types.hpp"
#include "faults/schedule/quantity.hpp"
#include "faults/schedule/schedule.hpp"

#include <optional>
#include <string>
#include <vector>

/// What a fault acts on, as the key `target` says it.
namespace evbal {

/// Regions to choose from, and how many are chosen: all of them without `pick`.
struct Target {
  std::vector<int> candidates;               ///< ascending; {no_region} for coordinator, injector and engine
  std::optional<Quantity> pick;              ///< how many, or the share of them
  bool share = false;                        ///< whether `pick` is a share
  ReportField field = ReportField::none;     ///< of sensor faults
  ProcessRole process = ProcessRole::agent;  ///< of process faults
  NetworkTopic topic = NetworkTopic::all;    ///< of network faults
};

/// Reads the key `target` of an entry, which faults of the engine do not have. Throws Error{bad_input} with what would
/// be right.
Target read_target(YamlMap& entry, const FaultType& type, const FaultContext& context);

/// Writes the target of a drawn fault, such as `{regions: [3, 7]}`, which read_target takes. The fault is not one of
/// the engine, which has no target.
void write_target(YamlWriter& yaml, const Fault& fault);

/// "region 3", "agent 3" or "the coordinator": where the fault acts, for messages.
std::string place_name(const Fault& fault, int region);

}  // namespace evbal

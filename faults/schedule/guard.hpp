#pragma once

#include "faults/schedule/entry.hpp"
#include "faults/schedule/schedule.hpp"

#include <optional>
#include <span>
#include <vector>

namespace evbal {

/// Where two faults that exclude each other meet: of a type in one region (and one field or topic), or of any types on
/// one process. The first such region and the ticks [from, to).
struct Overlap {
  int region = 0;  ///< where they meet
  int from = 0;    ///< tick
  int to = 0;      ///< tick after the last
};

/// Where two faults act on the same thing at the same time, if they do.
std::optional<Overlap> overlap(const Fault& a, const Fault& b, const DayClock& clock);

/// Reads the key `guard` of a schedule. Throws Error{bad_input}.
Guard read_guard(const YamlValue& value);

/// Throws Error{bad_input} at the fault that breaks a rule: a name used twice, two faults that exclude each other
/// at a time, more faults at a time or fewer working points than the guard allows.
void check_guard(const Guard& guard, std::span<const PlacedFault> faults, const FaultContext& context);

/// Whether faults keep all of these rules.
bool keeps_guard(const Guard& guard, const std::vector<Fault>& faults, const FaultContext& context);

}  // namespace evbal

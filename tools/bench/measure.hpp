#pragma once

#include <functional>
#include <optional>

namespace evbal {

/// What a piece of work cost.
struct Cost {
  double seconds = 0.0;    ///< of processor
  double megabytes = 0.0;  ///< most memory held at once, by the whole process
  bool ended = true;       ///< false: stopped at the limit, and would have cost more
};

/// Work that can be done again and again; false if it failed.
using Work = std::function<bool()>;

/// Prepares work and does it, in a process of its own, so that each measurement starts with the same memory. Work of
/// less than two seconds is repeated, and the least time counts: the rest is noise of the machine. Counts the programs
/// that it starts, not the preparation. Stops at `limit` seconds of processor; nothing if the work fails.
std::optional<Cost> measure(const std::function<Work()>& prepare, int limit);

}  // namespace evbal

#pragma once

#include <functional>
#include <optional>

namespace evbal {

/// What a piece of work cost.
struct Cost {
  double seconds = 0.0;    ///< of processor
  double megabytes = 0.0;  ///< most memory held at once, by the whole process
};

/// Work that can be done again and again; false if it failed.
using Work = std::function<bool()>;

/// Prepares work and does it, in a process of its own, so that each measurement starts with the same memory. Short work
/// is repeated, as processor clocks are coarse. Counts the programs that it starts, not the preparation. Nothing if the
/// work fails or takes more than `limit` seconds of processor.
std::optional<Cost> measure(const std::function<Work()>& prepare, int limit);

}  // namespace evbal

#pragma once

#include "coordinator/balancing/problem.hpp"
#include "coordinator/convex/start.hpp"

#include <cstdint>

namespace evbal {

/// What later decisions of a Ladder depend on.
struct LadderMemory {
  Dispatch last;                       ///< of the last solve that succeeded; no steps before the first
  std::int32_t minute = 0;             ///< at which `last` was made, its first step begins then
  std::uint64_t next_step = 0;         ///< the first step of `last` whose vehicles have not been sent
  std::int32_t failures_in_a_row = 0;  ///< decisions since the last solve that succeeded
  Start start;                         ///< of the engine for the next solve
};

}  // namespace evbal

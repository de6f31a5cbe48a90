#pragma once

#include "coordinator/balancing/problem.hpp"

#include <cstdint>

namespace evbal {

/// What later decisions of a Ladder depend on.
struct LadderMemory {
  Dispatch last;                ///< of the last solve that succeeded
  std::uint64_t next_step = 0;  ///< of `last`, if the next plan cannot be solved
  std::int32_t failures_in_a_row = 0;
};

}  // namespace evbal

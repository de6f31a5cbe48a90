#pragma once

#include "experiments/record/recorded_fault.hpp"

#include <algorithm>

namespace evbal {

/// Whether anybody saw the fault do something.
inline bool acted(const RecordedFault& fault) {
  return fault.evicted > 0 ||
         std::any_of(fault.amount.begin(), fault.amount.end(), [](const auto& seen) { return seen.second != 0.0; });
}

}  // namespace evbal

#pragma once

#include "faults/schedule/request.hpp"

#include <cstdint>
#include <vector>

namespace evbal {

/// Which of the schedules that a seed can give.
struct DrawKey {
  std::uint64_t seed = 0;  ///< of the schedule
  std::uint64_t run = 0;   ///< from 0
};

/// Draws what a request leaves open: one fault, or one for each arrival. An arrival where an earlier one still lasts is
/// left out: what is broken cannot break again. Every field draws from a stream of its own, keyed by (seed, run,
/// the fault's name, repetition, field): no fault and no field disturbs another's draws.
std::vector<Fault> draw_faults(const Request& request, const FaultContext& context, const DrawKey& key);

/// The magnitude of a fault in one region, where `drawn` is a draw of its quantity: points are those of the region.
double magnitude_in(const Request& request, const FaultContext& context, int region, double drawn);

}  // namespace evbal

#pragma once

#include "agents/protocol/fields.hpp"
#include "coordinator/balancing/problem.hpp"

#include <cstdint>

namespace evbal {

/// What later decisions of a Ladder depend on.
struct LadderMemory {
  Dispatch last;                ///< of the last solve that succeeded
  std::uint64_t next_step = 0;  ///< of `last`, if the next plan cannot be solved
  std::int32_t failures_in_a_row = 0;
};

template <class Visit>
void fields(Visit&& visit, Is<Flow> auto& m) {
  visit("from", m.from);
  visit("to", m.to);
  visit("amount", m.amount);
}

template <class Visit>
void fields(Visit&& visit, Is<LadderMemory> auto& m) {
  visit("vacant", m.last.vacant);
  visit("low_battery", m.last.low_battery);
  visit("next_step", m.next_step);
  visit("failures_in_a_row", m.failures_in_a_row);
}

}  // namespace evbal

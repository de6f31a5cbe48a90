#pragma once

#include "agents/protocol/bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

/// What the processes of a run journal (common/journal.hpp), as to_bytes writes it.
namespace evbal {

/// What an agent was told in a tick.
struct AgentEntry {
  Tick tick;               ///< as far as it concerns the agent's regions
  std::vector<Plan> plan;  ///< one where a plan was due
};

/// A plan that the coordinator made.
struct CoordinatorEntry {
  Tick tick;                    ///< that was due
  std::vector<Report> reports;  ///< that had come
  Plan plan;                    ///< that was made of them
  std::string memory;           ///< Planner::memory
};

/// The tick without what concerns only regions outside of [first, last].
inline Tick for_regions(Tick tick, int first, int last) {
  const auto elsewhere = [&](const auto& entry) { return entry.region < first || entry.region > last; };
  std::erase_if(tick.arrivals, elsewhere);
  std::erase_if(tick.under_way, elsewhere);
  std::erase_if(tick.effects, elsewhere);
  return tick;
}

/// The same of a plan.
inline Plan for_regions(Plan plan, int first, int last) {
  std::erase_if(plan.moves, [&](const Move& move) { return move.from < first || move.from > last; });
  return plan;
}

}  // namespace evbal

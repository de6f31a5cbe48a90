#pragma once

#include "agents/protocol/bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

/// The entries of the journals that the processes of a run keep (journal.hpp), as to_bytes writes them.
namespace evbal {

/// An agent's entry: what it was told in a tick.
struct AgentEntry {
  Tick tick;               ///< as far as it concerns the agent's regions
  std::vector<Plan> plan;  ///< one if a plan was due and came, else none
};

/// The coordinator's entry: a plan that it made, and from what.
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

/// The plan without the moves that start outside of [first, last].
inline Plan for_regions(Plan plan, int first, int last) {
  std::erase_if(plan.moves, [&](const Move& move) { return move.from < first || move.from > last; });
  return plan;
}

}  // namespace evbal

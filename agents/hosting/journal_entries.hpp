#pragma once

#include "agents/protocol/bytes.hpp"
#include "agents/protocol/region_range.hpp"

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

/// Whether a plan will come for any of the regions.
bool waits_for_plan(const Tick& tick, const RegionRange& regions);

/// The entry of the agent of these regions, one of which is due, for a tick and its plan as they were said to all; null
/// if there was none.
AgentEntry agent_entry(const Tick& tick, const Plan* plan, const RegionRange& regions);

/// The coordinator's entry: a plan that it made, and from what.
struct CoordinatorEntry {
  Tick tick;                    ///< that was due
  std::vector<Report> reports;  ///< that had come
  Plan plan;                    ///< that was made of them
  std::string memory;           ///< Planner::memory
};

}  // namespace evbal

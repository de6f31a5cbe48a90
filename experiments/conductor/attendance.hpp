#pragma once

#include "experiments/conductor/players.hpp"

#include <cstdint>
#include <set>
#include <vector>

namespace evbal {

/// Minutes after which nobody waits for a sample any more.
constexpr double report_deadline = 1.0;

/// Who takes part in a tick, and whose samples are in time, as the faults of processes and of the network will have it.
struct Attendance {
  Absences away;            ///< processes that are not there
  std::set<int> absent;     ///< regions whose agent is away
  std::set<int> unheard;    ///< regions whose report does not reach the coordinator in time
  std::set<int> unplanned;  ///< regions that no plan reaches in time
  std::vector<Seen> seen;   ///< absences, late and lost samples; of absent regions no samples

  /// Whether the coordinator is there.
  bool coordinator() const { return !away.contains("coordinator"); }
};

/// What a run depends on here.
struct RunShape {
  std::uint64_t seed = 0;       ///< of what the network loses
  int regions = 0;              ///< of the city
  int regions_per_process = 1;  ///< that one agent hosts
};

/// A fault of an agent acts on all regions that its process hosts. Samples are there only if `plan_due`; which of them
/// the network loses is drawn by (seed, region, tick, fault). The injector's own lateness is left to whoever hears it.
Attendance attendance(const std::vector<Effect>& effects, const RunShape& run, int tick, bool plan_due);

}  // namespace evbal

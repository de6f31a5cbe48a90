#pragma once

#include "experiments/record/day_file.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace evbal {

/// A fault of a finished run: as requested, as the injector said it, and as agents and coordinator saw it act.
struct RecordedFault : RequestedFault {
  std::map<int, std::set<int>> said{};  ///< ticks in which the injector said it, each with the regions; no_region: none
  std::map<int, double> amount{};  ///< ticks in which it was seen to act; the amounts (Observed) over all regions, of
                                   ///< solver faults 1 for a plan that fell back
  std::set<int> seen_regions{};    ///< in which it was seen to act
  int evicted = 0;                 ///< vehicles that lost their charging point
};

/// Reads the faults of a run.sqlite, in the order of the schedule. Throws what SQLiteCpp throws.
std::vector<RecordedFault> read_faults(const std::filesystem::path& file);

}  // namespace evbal

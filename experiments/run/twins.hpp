#pragma once

#include "common/pipe.hpp"
#include "common/workers.hpp"
#include "experiments/run/record_day.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace evbal {

/// A scenario under one of its controllers, and where it is recorded.
struct Run {
  Scenario scenario;             ///< with one controller
  std::filesystem::path folder;  ///< where it is recorded
};

/// A run for each of the scenario's controllers: in `folder`, or in a folder of the controller's name in it if there
/// are several.
std::vector<Run> runs_of(const Scenario& scenario, const std::filesystem::path& folder);

/// Plays the run by its scenario's transport; `on_tick` and `door` as in Stage. Throws as record_day.
RunResult record(const Run& run, const std::function<void(const TickRecord&)>& on_tick = {},
                 const std::optional<DoorOptions>& door = {});

/// The twins of runs, which are the same without faults (paired_run.hpp): a process of its own plays and records those
/// that are needed. Those that are recorded to their end already are left as they are, what is left of others is
/// removed.
class Twins {
 public:
  /// Starts the process. No other thread may run.
  explicit Twins(const std::vector<Run>& runs);

  /// The twin of the run at this position is needed: it is played as soon as those before it are.
  void need(std::size_t run);

  /// Waits until all twins that are needed are recorded. Throws Error{run_failed}.
  void await();

 private:
  Pipe needed_;  ///< positions of runs
  std::set<std::size_t> asked_;
  Workers worker_;
};

}  // namespace evbal

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

/// What a day has come to, in a few numbers. Passes a pipe as bytes.
struct DayTally {
  int run = 0;            ///< position of the day's run
  int tick = 0;           ///< that is over
  long served = 0;        ///< passengers so far
  long lost = 0;          ///< passengers so far
  long waiting = 0;       ///< passengers
  long vacant = 0;        ///< vehicles
  long queue = 0;         ///< low-battery vehicles that are not charging
  double empty_km = 0.0;  ///< driven without passengers so far
};

/// The same with one more tick.
DayTally with_tick(DayTally so_far, const TickRecord& tick);

/// The twins of runs, which are the same without faults (paired_run.hpp): a process of its own plays and records those
/// that are needed. Those that are recorded to their end already are left as they are, what is left of others is
/// removed.
class Twins {
 public:
  /// Starts the process. No other thread may run.
  explicit Twins(const std::vector<Run>& runs);

  /// The twin of the run at this position is needed: it is played as soon as those before it are.
  void need(std::size_t run);

  /// What the twin of the run at this position has come to, by tick, since the last call; does not wait. What twins of
  /// other runs have come to is forgotten.
  std::vector<DayTally> heard(std::size_t run);

  /// Waits until all twins that are needed are recorded. Throws Error{run_failed}.
  void await();

 private:
  Pipe needed_;  ///< positions of runs
  Pipe played_;  ///< DayTallies
  std::set<std::size_t> asked_;
  Workers worker_;
};

}  // namespace evbal

#pragma once

#include "experiments/study/design/sweep.hpp"
#include "experiments/study/executors/play_days.hpp"
#include "experiments/study/store/sweep_folder.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace evbal {

/// How a sweep's days are played, none of which changes their results.
struct Playing {
  int jobs = 0;                    ///< days at a time; 0: one a core, or as many as Slurm likes
  std::string executor = "local";  ///< or "slurm"
  /// A day that takes longer is ended, and has failed; 0: none is.
  std::chrono::seconds day_limit = std::chrono::seconds::zero();
  OnDayEnded on_day_ended{};  ///< is told of each day
};

/// Plays the days that have no result in the folder yet; `keys` are the days' (day_keys.hpp). Gives those that failed
/// twice; the others have their results.
[[nodiscard]] std::vector<FailedDay> play_sweep(const Sweep& sweep, const std::vector<std::string>& keys,
                                                const SweepFolder& folder, const Playing& playing);

/// Throws Error{run_failed} with the days of a sweep that failed, if there are any.
void refuse_failed(const std::vector<FailedDay>& failed, const Sweep& sweep);

}  // namespace evbal

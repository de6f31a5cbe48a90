#pragma once

#include "experiments/study/design/sweep.hpp"
#include "experiments/study/executors/play_days.hpp"
#include "experiments/study/store/sweep_folder.hpp"

#include <string>
#include <vector>

namespace evbal {

/// How a sweep's days are played, none of which changes their results.
struct Playing {
  int jobs = 0;                    ///< days at a time; 0: one a core, or as many as Slurm likes
  std::string executor = "local";  ///< or "slurm"
  OnDayEnded on_day_ended{};       ///< is told of each day
};

/// Plays the days that have no result in the folder yet; `keys` are the days' (day_keys.hpp). Throws Error{run_failed}
/// if days failed.
void play_sweep(const Sweep& sweep, const std::vector<std::string>& keys, const SweepFolder& folder,
                const Playing& playing);

}  // namespace evbal

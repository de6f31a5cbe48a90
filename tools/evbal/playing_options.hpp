#pragma once

#include "experiments/study/executors/play_sweep.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace evbal {

/// What `evbal sweep` and `evbal tune` ask alike.
struct PlayingOptions {
  Playing playing;     ///< but for what is told of days that end
  bool quiet = false;  ///< without progress
};

/// Adds `--jobs`, `--executor`, `--day-limit` and `--quiet` to a command.
void add_playing_options(CLI::App& command, PlayingOptions& options);

/// Plays the days as asked for, shows progress, and says which were played by other programs. Gives what play_sweep
/// gives.
[[nodiscard]] std::vector<FailedDay> play_shown(const Sweep& sweep, const std::vector<std::string>& keys,
                                                const SweepFolder& folder, const PlayingOptions& options);

}  // namespace evbal

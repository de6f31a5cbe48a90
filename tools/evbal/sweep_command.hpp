#pragma once

#include "tools/evbal/playing_options.hpp"

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal sweep SWEEP.yaml`: plays the days of a sweep that are not played yet, several at a time, and gathers
/// what they came to in one directory. The command throws Error, whose status main exits with.
void add_sweep_command(CLI::App& app);

/// The command line of `evbal sweep`.
struct SweepArguments {
  std::filesystem::path sweep;  ///< as given
  std::string out;              ///< folder; empty: one under runs/
  bool quick = false;           ///< read_sweep
  PlayingOptions options;       ///< how its days are played
};

/// Plays the days of a sweep that are not played yet, those of its tuning first, and gives its days.csv. Throws Error.
std::filesystem::path sweep(const SweepArguments& arguments);

}  // namespace evbal

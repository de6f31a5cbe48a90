#pragma once

#include "tools/evbal/playing_options.hpp"

#include <filesystem>

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal tune TUNING.yaml`: gives every variant the same training days and writes down the best settings of each
/// (docs/tuning.md). The command throws Error, whose status main exits with.
void add_tune_command(CLI::App& app);

/// The command line of `evbal tune`.
struct TuneArguments {
  std::filesystem::path tuning;  ///< file
  std::filesystem::path out;     ///< folder for what was tuned
  bool quick = false;            ///< read_tuning
  PlayingOptions options;        ///< how its days are played
};

/// Tunes, for which it plays the days that have no result in `out` yet, and gives the file with the settings that it
/// found. Throws Error.
std::filesystem::path tune(const TuneArguments& arguments);

}  // namespace evbal

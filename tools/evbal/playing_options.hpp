#pragma once

#include "experiments/study/executors/play_sweep.hpp"

namespace CLI {
class App;
}

namespace evbal {

/// Adds the options that `playing` is made from.
void add_playing_options(CLI::App& command, Playing& playing);

}  // namespace evbal

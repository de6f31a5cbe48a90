#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal study BENCHMARK --controller NAME`, which examines a controller on a frozen benchmark and writes one
/// line of results, and `evbal study verify FILE`, which plays a tenth of such a line's days again
/// (docs/leaderboard.md). The commands throw Error, whose status main exits with.
void add_study_command(CLI::App& app);

}  // namespace evbal

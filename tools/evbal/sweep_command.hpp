#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal sweep SWEEP.yaml`: plays the days of a sweep that are not played yet, several at a time, and gathers
/// what they came to in one directory. The command throws Error, whose status main exits with.
void add_sweep_command(CLI::App& app);

}  // namespace evbal

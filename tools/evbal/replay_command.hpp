#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal replay DIR`: runs again, in this process, what a run directory holds, and compares every recorded value.
/// The command throws Error, whose status main exits with.
void add_replay_command(CLI::App& app);

}  // namespace evbal

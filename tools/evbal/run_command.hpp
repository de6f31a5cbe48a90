#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal run SCENARIO.yaml`: plays the day of a scenario under each of its controllers, shows progress, and
/// leaves a run directory for each. The command throws Error, whose status main exits with.
void add_run_command(CLI::App& app);

}  // namespace evbal

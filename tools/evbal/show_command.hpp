#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal show SCENARIO`: the scenario with everything explicit, and where each value comes from. What it prints
/// is a scenario again. The command throws Error, whose status main exits with.
void add_show_command(CLI::App& app);

}  // namespace evbal

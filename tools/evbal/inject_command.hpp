#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal inject`.
void add_inject_command(CLI::App& app);

}  // namespace evbal

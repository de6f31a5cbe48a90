#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal list KIND`: names what is shipped and what may be named in scenarios. The command throws Error, whose
/// status main exits with.
void add_list_command(CLI::App& app);

}  // namespace evbal

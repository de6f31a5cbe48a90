#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal complete -- WORD...`, by which a shell completes a command line; help does not show it. `app` has to
/// outlive the parsing.
void add_complete_command(CLI::App& app);

}  // namespace evbal

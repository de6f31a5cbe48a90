#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal report DIR...`: one HTML page on finished runs.
/// The command throws Error, whose status main exits with.
void add_report_command(CLI::App& app);

}  // namespace evbal

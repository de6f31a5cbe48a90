#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal compare DIR --against VARIANT`: the variants of a finished sweep against one of them, with intervals.
/// The command throws Error, whose status main exits with.
void add_compare_command(CLI::App& app);

}  // namespace evbal

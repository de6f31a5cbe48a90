#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal search SCENARIO`: finds the schedule of faults that hurts the day most, and makes it small
/// (docs/search.md). The command throws Error, whose status main exits with.
void add_search_command(CLI::App& app);

}  // namespace evbal

#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal ingest trips` and `evbal ingest synthetic`: raw records, or a seed, to a city pack (docs/city-packs.md).
/// They throw Error as every command does.
void add_ingest_command(CLI::App& app);

}  // namespace evbal

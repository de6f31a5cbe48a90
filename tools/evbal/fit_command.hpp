#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal fit CITY [--tau STEPS] [--out FILE]`: estimates forecasts, uncertainty sets and transitions from the
/// city's training days and writes the model file beside the pack (docs/fit.md).
void add_fit_command(CLI::App& app);

}  // namespace evbal

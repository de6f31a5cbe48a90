#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal verify [CITY]`: holds the optimisation against solvers that are not ours (docs/theorem-1.md) and prints
/// the largest difference of each kind; ends with expectation_failed if one is larger than allowed.
void add_verify_command(CLI::App& app);

}  // namespace evbal

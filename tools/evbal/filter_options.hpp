#pragma once

#include "experiments/study/design/day_filter.hpp"

#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace evbal {

/// Adds `--scenario`, `--faults`, `--variant` and `--days` to a command, each for one name or several, and gives these
/// options.
std::vector<CLI::Option*> add_filter_options(CLI::App& command, DayFilter& filter);

}  // namespace evbal

#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// `evbal bound`: the least passengers that a day must lose, whoever plans it.
void add_bound_command(CLI::App& app);

}  // namespace evbal

#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// What may follow a command on the command line, by name.
namespace evbal {

/// The long names of a command's options, with their dashes.
std::vector<std::string> option_names(const CLI::App& command);

/// The commands below a command that its help shows.
std::vector<std::string> command_names(const CLI::App& command);

}  // namespace evbal

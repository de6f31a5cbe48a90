#pragma once

#include "common/command.hpp"

#include <filesystem>

/// Commands that make the plans in place of evbal-coordinator (docs/your-own-controller.md).
namespace evbal {

/// The controller's own words: without `evbal-bridge`, which a child in lines of JSON needs on the bus alone.
Command own_words(Command coordinator);

/// Whether the command is a shared library (evbal_controller.h) and no program.
bool is_library(const Command& own_words);

/// What takes part on the bus for a coordinator: evbal-bridge for a library, else the command itself.
Command on_the_bus(Command coordinator);

/// The program or library that a command begins with. Throws Error{bad_input} if there is none.
std::filesystem::path file_of(const Command& coordinator);

}  // namespace evbal

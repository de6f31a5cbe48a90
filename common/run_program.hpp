#pragma once

#include "common/command.hpp"

#include <chrono>
#include <string>

namespace evbal {

/// What a program said and how it ended.
struct ProgramResult {
  int status = 0;      ///< as waitpid gives it: 0 if it ended well; ending(status) says it in words
  std::string output;  ///< all of its standard output
  std::string errors;  ///< all of its standard error output
};

/// Runs a program without a shell (spawn.hpp) and without input, and waits until it ends. Throws Error{run_failed} if
/// it cannot be started, or if it does not end in time; it is killed then.
ProgramResult run_program(const Command& command, std::chrono::milliseconds at_most);

}  // namespace evbal

#pragma once

#include "common/command.hpp"

#include <sys/types.h>

#include <string>

namespace evbal {

/// Open files of this process that a new one gets as its standard input, output and error output.
struct StandardStreams {
  int input = 0;   ///< file descriptor of its standard input
  int output = 1;  ///< file descriptor of its standard output
  int errors = 2;  ///< file descriptor of its standard error
};

/// Starts a program, looked for in $PATH if it has no slash, and gives its process id. It has no other open file than
/// `streams`, is in a process group of its own (Ctrl-C is not for it), blocks no signal, and ignores only what this
/// process was started to ignore, as under nohup. It is killed when the calling thread ends. Its environment is this
/// process's, with `mark` ("NAME=value") besides unless that is empty. Throws Error{run_failed} if it cannot be
/// started.
pid_t spawn(const Command& command, const StandardStreams& streams, const std::string& mark = {});

/// Kills every process of this user that was started with `mark` in its environment, as all are whom a process so
/// marked has started, unless they clear their environment.
void kill_marked(const std::string& mark);

/// Whether somebody else ended the process whose status waitpid gave. One that aborts, crashes or exits ended by itself
/// and would do so again.
bool ended_from_outside(int status);

/// How a process ended: "ended with status 7", "was ended by signal 9 (Killed)".
std::string ending(int status);

}  // namespace evbal

#pragma once

namespace evbal {

/// The main of evbal-bridge. The command line holds the command of a child process and then what evbal tells a
/// coordinator. The child is told and answers as json_lines.hpp says. A child that cannot be started, ends, or answers
/// anything else ends the bridge with a line on stderr and an exit status.
int run_bridge(int argc, char** argv);

}  // namespace evbal

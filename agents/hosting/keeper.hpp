#pragma once

#include <string>

namespace evbal {

/// The first word of evbal-agent's command line that makes it a keeper.
inline constexpr auto keeper_word = "keep";

/// The main of a keeper: the one process that a run starts on another host (host_words.hpp), which starts all others
/// there and lends its own program to them. Its arguments are keeper_word, the IPv4 address of the host, and the lease:
/// after so many seconds without a word from its launcher the keeper takes it to be dead. It works in the current
/// directory, which is the run's folder over there. When its standard input ends, or with the lease, it kills its
/// processes, removes the folder and ends. If it is killed itself, the kernel kills its processes.
int run_keeper(int argc, char** argv);

}  // namespace evbal

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// Something that a run which has broken off left behind.
struct Leftover {
  std::string what;              ///< "evbal-agent (process 4711) of run 4700-123"
  std::function<void()> remove;  ///< if it is still what it was; throws Error{run_failed} if it cannot be removed
};

/// What is left of runs that broke off: their processes on this machine, their journals and keys in the folder runs/ of
/// the current directory, which nothing will read any more, and their folders on the hosts that runs in runs/ name.
/// What cannot be read is passed over; a host that cannot be asked is one of the leftovers, which cannot be removed.
std::vector<Leftover> find_leftovers();

}  // namespace evbal

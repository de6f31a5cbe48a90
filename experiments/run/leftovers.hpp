#pragma once

#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// Something of a run that is no more.
struct Leftover {
  std::string what;              ///< "evbal-agent (process 4711) of run 4700-123"
  std::function<void()> remove;  ///< if it is still what it was; throws Error{run_failed} if it cannot be removed
};

/// What runs left over that did not end by themselves: their processes, and below runs/ here the journals that only a
/// run which goes on has any use for.
std::vector<Leftover> find_leftovers();

}  // namespace evbal

#pragma once

#include "experiments/study/design/sweep.hpp"
#include "tools/evbal/playing_options.hpp"

namespace evbal {

/// Computes the bounds that a sweep wants of its days and that are not kept yet (kept_bound), several at a time, on
/// this machine. Says on stderr how far it has come, unless quiet. Throws Error.
void bound_days(const Sweep& sweep, const PlayingOptions& options);

}  // namespace evbal

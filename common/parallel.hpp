#pragma once

#include <cstddef>
#include <functional>

namespace evbal {

/// Calls `work` with 0..count-1, each once, in any order, on as many threads as there are processors. What one call
/// writes no other may touch: then results do not depend on the threads. `work` must not throw.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace evbal

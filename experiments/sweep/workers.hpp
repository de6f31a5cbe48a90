#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// Does each of `jobs`, `at_a_time` of them at a time, each in a process of its own: solvers are made for one solve at
/// a time in a process, and one that crashes takes nobody along. `done` hears of each that ends, here, with what went
/// wrong or an empty text. If this process dies the others do; if `done` or an interrupt ends the work early they are
/// ended. Throws Error{run_failed} if no process can be started. No other thread may run meanwhile.
void work_through(const std::vector<std::size_t>& jobs, int at_a_time, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& done);

}  // namespace evbal

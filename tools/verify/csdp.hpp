#pragma once

#include <string>
#include <vector>

namespace evbal {

/// The optimal variables of a semidefinite program in SDPA's sparse format, found by the program `csdp`.
/// Throws Error{run_failed} if there is no such program or if it does not reach its full accuracy.
std::vector<double> solve_with_csdp(const std::string& problem);

}  // namespace evbal

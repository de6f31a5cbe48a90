#pragma once

#include <vector>

namespace evbal {

/// Probability that a charging session which has lasted `so_far` minutes ends within the next `minutes`: by the
/// session's quantiles, which stand at equally spaced probabilities; linear between them, 1 beyond the last.
double share_that_ends(const std::vector<double>& session_quantiles, double so_far, double minutes);

}  // namespace evbal

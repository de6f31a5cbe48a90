#include "coordinator/planning/charging_sessions.hpp"

#include <algorithm>
#include <iterator>

namespace evbal {
namespace {

/// Share of the sessions that last at most `minutes`.
double share_ended(const std::vector<double>& quantiles, double minutes) {
  const auto above = std::upper_bound(quantiles.begin(), quantiles.end(), minutes);
  if (above == quantiles.begin() || above == quantiles.end()) {
    return above == quantiles.begin() ? 0.0 : 1.0;
  }
  const double low = *std::prev(above);
  const auto below = static_cast<double>(above - quantiles.begin() - 1);
  return (below + (minutes - low) / (*above - low)) / static_cast<double>(quantiles.size() - 1);
}

}  // namespace

double share_that_ends(const std::vector<double>& session_quantiles, double so_far, double minutes) {
  const double ended = share_ended(session_quantiles, so_far);
  return ended < 1.0 ? (share_ended(session_quantiles, so_far + minutes) - ended) / (1.0 - ended) : 1.0;
}

}  // namespace evbal

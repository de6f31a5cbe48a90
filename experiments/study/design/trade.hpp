#pragma once

#include <optional>
#include <string>
#include <vector>

/// What metrics are to a comparison.
namespace evbal {

/// The metrics at whose equal values controllers are compared.
std::vector<std::string> traded_metrics();

/// What a controller gives up for less of `cost`: lost passengers for idle km, and the reverse, both also `_after_7`.
/// Nothing for another metric.
std::optional<std::string> traded_for(const std::string& cost);

/// Whether a metric is a sum over the day, none of whose parts is negative, so that it may be told as a ratio; others,
/// such as shares and mean waits, are told as differences.
bool adds_up(const std::string& metric);

}  // namespace evbal

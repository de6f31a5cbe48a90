#pragma once

#include "tools/gps/fixes.hpp"

#include <optional>
#include <span>
#include <vector>

namespace evbal {

/// Whether a car that was at `before` can be at `after`: later, by a week at most, and no further off than a car drives
/// in that time.
bool can_drive(const Fix& before, const Fix& after);

/// Of the fixes of one vehicle, in the order in which they were recorded, as many as it can have driven one after the
/// other; their positions, ascending, and their times ascend as well. The others are outliers in place or in time. A
/// fix that can_drive() does not reach may still begin another part of the records, if ten fixes at least speak for it.
/// `last` is the vehicle's fix before them, after which all that are taken come.
std::vector<std::size_t> longest_drive(std::span<const Fix> fixes, const std::optional<Fix>& last);

}  // namespace evbal

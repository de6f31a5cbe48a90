#pragma once

#include "experiments/bound/bound_front.hpp"
#include "experiments/study/design/finished_day.hpp"

#include <filesystem>
#include <vector>

namespace evbal {

/// The name under which the bound stands among the variants of a sweep.
inline constexpr const char* bound_variant = "bound";

/// The corners of a day's bound (bound_corners) as days like `day`: settings of that variant, of which idle_km and lost
/// are known.
std::vector<FinishedDay> bound_points(const std::vector<Driving>& corners, FinishedDay day);

/// The bounds that are kept for days of a sweep, as if they were days of one more variant: a setting for each corner of
/// a day's bound, of which idle_km and lost are known. `days` are those of `sweep_file`. Only days of its first
/// scenario and schedule of faults are looked for, which must be without any. Throws Error{bad_input} if it is not, or
/// if no bound is kept for any of them.
std::vector<FinishedDay> bounded_days(const std::filesystem::path& sweep_file, const std::vector<FinishedDay>& days);

}  // namespace evbal

#pragma once

#include "experiments/bound/bound_front.hpp"
#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/design/sweep.hpp"
#include "experiments/study/store/bound_keys.hpp"

#include <filesystem>
#include <vector>

namespace evbal {

/// The corners of a day's bound (bound_corners) as days like `day`: settings of the variant `bound`, of which idle_km
/// and lost are known.
std::vector<FinishedDay> bound_points(const std::vector<Driving>& corners, FinishedDay day);

/// Under which name the bound of each of a sweep's days is kept, once it is computed: one for each scenario, schedule
/// of faults, day and seed. Throws Error{bad_input} if a day's scenario is wrong.
std::vector<BoundKey> bound_keys_of(const Sweep& sweep);

/// The bounds that are kept for days of a sweep, as if they were days of one more variant: a setting for each corner of
/// a day's bound, of which idle_km and lost are known. `days` are those of `sweep_file`. None if no bound is kept, or
/// if the file does not say which ones it needs.
std::vector<FinishedDay> kept_bounds(const std::filesystem::path& sweep_file, const std::vector<FinishedDay>& days);

/// The same. Throws Error{bad_input} if there are none.
std::vector<FinishedDay> bounded_days(const std::filesystem::path& sweep_file, const std::vector<FinishedDay>& days);

}  // namespace evbal

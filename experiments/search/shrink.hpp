#pragma once

#include "experiments/search/worst_search.hpp"

#include <functional>
#include <vector>

namespace evbal {

/// Takes away from the schedule of `found`, which is one of `trials`, what it can do without while its harm stays
/// `enough`: faults first, then regions of faults, then minutes at either end and magnitude, by halves, quarters and
/// eighths of what is left, in whole ticks and whole things, and numbers at least by a twentieth of what their entry
/// likely gives. First each part alone; of those that can go, as many at once as can, in eighths of them; of faults at
/// most the best quarter, and then all again. Where no fault can go alone, one goes while another changes (moves.hpp),
/// if one of some changes leaves enough. Ends with a schedule from which no single part of these can go. Schedules
/// that it tries are added to `trials`. Gives the smallest.
///
/// `enough` must hold of the first harm, and not of that of no faults.
Trial shrink(const Ingredients& ingredients, const Trial& found, const std::function<bool(double)>& enough,
             const Harms& harms, std::vector<Trial>& trials);

}  // namespace evbal

#pragma once

#include "common/random.hpp"
#include "experiments/search/ingredients.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace evbal {

/// A schedule that was made from another by one change.
struct ChangedSchedule {
  Picks picks;         ///< the new schedule
  std::string change;  ///< "outage-2: start"
};

/// Changes one fault: its start, duration, regions or magnitude, within what its entry leaves open and likely gives
/// (Quantity::likely); or puts a drawn fault of any entry in its place or beside it. The schedule keeps the guard, has
/// `most` faults at most, and one at most of an entry with a `start`. Nothing if no such change was found.
std::optional<ChangedSchedule> moved(const Ingredients& ingredients, const Picks& picks, std::size_t most,
                                     RandomStream& stream);

}  // namespace evbal

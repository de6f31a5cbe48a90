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

/// What moves build with, beside the entries.
struct MoveStock {
  std::size_t most = 1;  ///< faults that a schedule has at most
  Picks harmful{};       ///< faults of schedules that did much harm
};

/// Random numbers for a move that makes the schedule `number`; no draw of faults has them.
RandomStream move_stream(const Ingredients& ingredients, std::size_t number, std::size_t attempt);

/// Changes one fault: its start, duration, regions or magnitude, within what its entry leaves open and likely gives
/// (Quantity::likely); or puts another in its place or beside it: three of four times a harmful one of the stock, else
/// a drawn fault of any entry. The schedule keeps the guard, has not more faults than the stock allows, and one at most
/// of an entry with a `start`. Nothing if no such change was found.
std::optional<ChangedSchedule> moved(const Ingredients& ingredients, const Picks& picks, const MoveStock& stock,
                                     RandomStream& stream);

}  // namespace evbal

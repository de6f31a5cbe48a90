#pragma once

#include "common/yaml.hpp"
#include "faults/schedule/request.hpp"
#include "faults/schedule/schedule.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The search for the schedule of faults that hurts a day most (docs/search.md).
namespace evbal {

/// What a search makes schedules from: the entries of a schedule of faults, with all that they leave open.
struct Ingredients {
  std::uint64_t seed = 0;          ///< of draws and moves
  Guard guard{};                   ///< that every schedule keeps
  std::vector<Request> entries{};  ///< in the order of the file, with names of their own
  FaultContext context;            ///< the day and the city
};

/// Reads the keys of a schedule that is not resolved; `runs` is read and not used. The caller asks `map` for its own
/// keys and calls finish(). Throws Error{bad_input} if the list is empty, or a name is given twice.
Ingredients read_ingredients(YamlMap& map, const FaultContext& context);

/// A fault of a schedule, and the entry that it is one of.
struct Pick {
  std::size_t entry = 0;  ///< position in Ingredients::entries
  Fault fault;            ///< resolved

  /// Field by field.
  bool operator==(const Pick&) const = default;
};

/// The faults of one schedule, by entry and time.
using Picks = std::vector<Pick>;

/// The same in order, named as their entries are: with a number behind the name where there may be several.
Picks in_order(Picks picks, const Ingredients& ingredients);

/// The faults as a schedule.
Schedule schedule_of(const Picks& picks, const Ingredients& ingredients);

/// Whether they keep the guard.
bool keeps_guard(const Picks& picks, const Ingredients& ingredients);

/// The first `count` draws of the entries that keep the guard. Throws Error{bad_input} if hardly any does.
std::vector<Picks> random_draws(const Ingredients& ingredients, std::size_t count);

}  // namespace evbal

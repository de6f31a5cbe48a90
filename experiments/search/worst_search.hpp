#pragma once

#include "experiments/search/ingredients.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// A schedule that a search tried.
struct Trial {
  std::size_t number = 0;  ///< from 1, in the order in which they were asked for
  std::string stage{};     ///< "draw", "move" or "shrink"
  std::size_t parent = 0;  ///< number of the trial that it was made from; 0: of none
  std::string change{};    ///< what was changed in the parent
  Picks picks{};           ///< the schedule
  double harm = 0.0;       ///< that it does; the more, the worse
};

/// Says what harm each of several schedules does. A pure function: the same schedule does the same harm.
using Harms = std::function<std::vector<double>(const std::vector<Trial>&)>;

/// Draws that a search of `budget` schedules begins with: the first third.
std::size_t first_draws(std::size_t budget);

/// Tries `budget` schedules, at least 1: random draws (ingredients.hpp), then moves (moves.hpp) of the four best of
/// them, later of the two and the one that have come furthest. A move that does not less harm takes its parent's place.
/// Their stock: no more faults than the draw with most, and those of the eight best draws. Which schedules are tried
/// depends on ingredients, budget and harms alone.
std::vector<Trial> search_worst(const Ingredients& ingredients, std::size_t budget, const Harms& harms);

/// The first of those that do most harm; there must be one.
const Trial& most_harmful(const std::vector<Trial>& trials);

}  // namespace evbal

#pragma once

#include "experiments/sweep/sweep.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// How the days of a sweep are worked through, none of which changes what they come to.
struct Labour {
  int at_a_time = 1;
  bool quiet = false;  ///< without progress
};

/// As many days at a time as there are cores.
int cores();

/// Plays the days of a sweep whose keys have no result in `file` yet, by `play` of the day's position, in processes of
/// their own; it adds the result. Shows progress on stderr. Gives a line for each day that failed.
std::string play_days(const Sweep& sweep, const std::vector<std::string>& keys, const std::filesystem::path& file,
                      const Labour& labour, const std::function<void(std::size_t)>& play);

}  // namespace evbal

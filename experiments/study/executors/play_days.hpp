#pragma once

#include "experiments/study/design/sweep.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// Hears of each day that ends, with what went wrong or an empty text.
using Done = std::function<void(std::size_t, const std::string&)>;

/// How the days of a sweep are worked through, none of which changes what they come to.
struct Labour {
  int at_a_time = 1;
  bool quiet = false;  ///< without progress
};

/// As many days at a time as there are cores.
int cores();

/// Has `work` do the days of a sweep whose keys have no result in `file` yet, given by their positions; it adds the
/// results. Shows progress on stderr. Gives a line for each day that failed.
std::string do_days(const Sweep& sweep, const std::vector<std::string>& keys, const std::filesystem::path& file,
                    bool quiet, const std::function<void(const std::vector<std::size_t>&, const Done&)>& work);

/// Plays the days of a sweep whose keys have no result in `file` yet, by `play` of the day's position, in processes of
/// their own; it adds the result. Shows progress on stderr. Gives a line for each day that failed.
std::string play_days(const Sweep& sweep, const std::vector<std::string>& keys, const std::filesystem::path& file,
                      const Labour& labour, const std::function<void(std::size_t)>& play);

}  // namespace evbal

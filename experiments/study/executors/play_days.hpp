#pragma once

#include "experiments/study/design/sweep.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// A day that has just ended, and how far its sweep has come.
struct DayEnded {
  std::string day;        ///< variant, settings, faults, date and seed
  bool failed = false;    ///< without a result
  bool again = false;     ///< failed for the first time, and is tried once more
  std::size_t ended = 0;  ///< days of the sweep that have ended, those of earlier calls among them
  std::size_t all = 0;    ///< days of the sweep
};

/// Is told of each day that ends; may be empty.
using OnDayEnded = std::function<void(const DayEnded&)>;

/// Takes the position of a day that has ended, with what went wrong or an empty text.
using Done = std::function<void(std::size_t, const std::string&)>;

/// Does the days with these positions, adds their results to the sweep's file, and tells of each.
using Work = std::function<void(const std::vector<std::size_t>&, const Done&)>;

/// The number of processor cores.
int cores();

/// A day of a sweep that failed twice.
struct FailedDay {
  std::string day;     ///< variant, settings, faults, date and seed
  std::string reason;  ///< of the second time
};

/// The days in lines for a message, of many only the first ones.
std::string shown(const std::vector<FailedDay>& failed);

/// Has `work` do the days of a sweep whose keys have no result in `file` yet, and those that fail once more. Notes
/// the failures in the file, and gives the days that failed twice, in the order of the sweep.
std::vector<FailedDay> do_days(const Sweep& sweep, const std::vector<std::string>& keys,
                               const std::filesystem::path& file, const OnDayEnded& on_day_ended, const Work& work);

}  // namespace evbal

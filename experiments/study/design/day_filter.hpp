#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace evbal {

/// Which days of a sweep are asked for: those that have one of the names in each list. An empty list takes all.
struct DayFilter {
  std::vector<std::string> scenarios{};  ///< names in the sweep
  std::vector<std::string> faults{};     ///< names of schedules
  std::vector<std::string> variants{};   ///< names
  std::vector<std::string> days{};       ///< ISO 8601
};

/// Whether it takes all days.
inline bool is_empty(const DayFilter& filter) {
  return filter.scenarios.empty() && filter.faults.empty() && filter.variants.empty() && filter.days.empty();
}

/// Throws Error{bad_input} unless each of `asked` is one of `there`, with these and the one that may be meant.
/// `option`, as on the command line, is named in the message.
void expect_names(const std::string& option, const std::vector<std::string>& asked,
                  const std::vector<std::string>& there);

/// The positions of the days that are asked for, of SweptDay or FinishedDay. Throws Error{bad_input} if a name is that
/// of no day, or no day is left.
template <class Day>
std::vector<std::size_t> positions_of(const DayFilter& filter, const std::vector<Day>& days);

/// What stands at these positions of `all`.
template <class Item>
std::vector<Item> at_positions(const std::vector<std::size_t>& positions, const std::vector<Item>& all) {
  std::vector<Item> chosen;
  std::transform(positions.begin(), positions.end(), std::back_inserter(chosen), [&](std::size_t i) { return all[i]; });
  return chosen;
}

/// The days that are asked for. Throws as positions_of.
template <class Day>
std::vector<Day> filtered(const DayFilter& filter, const std::vector<Day>& days) {
  return at_positions(positions_of(filter, days), days);
}

}  // namespace evbal

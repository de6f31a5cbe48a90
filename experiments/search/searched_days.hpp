#pragma once

#include "experiments/scenario/scenario.hpp"
#include "experiments/search/worst_search.hpp"
#include "experiments/study/executors/day_keys.hpp"
#include "experiments/study/executors/play_sweep.hpp"
#include "experiments/study/store/sweep_folder.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace evbal {

/// Plays a scenario's day with the schedules that a search tries. Results gather in the folder's file
/// (store/sweep_file.hpp): no schedule is played twice, whenever the search goes on.
class SearchedDays {
 public:
  /// The scenario has one controller and no coordinator of its own; `expected` days are shown as the whole. What is
  /// given has to outlive the object.
  SearchedDays(const Scenario& scenario, const Ingredients& ingredients, const SweepFolder& folder, Playing playing,
               std::size_t expected);

  /// The day with this schedule, as a scenario of its own.
  Scenario with(const Picks& picks) const;

  /// A metric of the day under each schedule, by metric_names(). Throws as play_sweep.
  std::vector<double> values(const std::vector<Trial>& trials, const std::string& metric);

  /// The keys of all days that were asked for.
  const std::vector<std::string>& used() const { return used_; }

 private:
  const Scenario& scenario_;
  const Ingredients& ingredients_;
  const SweepFolder& folder_;
  Playing playing_;
  std::size_t expected_;
  std::size_t asked_ = 0;  ///< days in earlier calls
  DayKeys keys_;
  std::vector<std::string> used_;
};

}  // namespace evbal

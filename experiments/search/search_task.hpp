#pragma once

#include "experiments/scenario/scenario.hpp"
#include "experiments/search/ingredients.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace evbal {

/// What is searched: schedules for a scenario's day that push a metric the wrong way.
struct SearchTask {
  Scenario scenario;               ///< without faults; one controller
  Ingredients ingredients{};       ///< that schedules are made from
  std::optional<Expect> expect{};  ///< what shall hold of the worst
  std::string metric{};            ///< by metric_names()
  bool more_is_worse = true;       ///< of the metric; else less

  /// What a value of the metric is worse than another one, its harm.
  double harm(double value, double without) const { return more_is_worse ? value - without : without - value; }

  /// The other way round.
  double value(double harm, double without) const { return more_is_worse ? without + harm : without - harm; }
};

/// Reads a scenario for a search. Its ingredients are its own schedule of faults or that of `overrides`, its metric
/// that of its expectation under search, else `metric`, else `lost`. Throws Error{bad_input} with file, line, reason
/// and what would be right.
SearchTask read_search_task(const std::filesystem::path& file, const Overrides& overrides, const std::string& metric);

}  // namespace evbal

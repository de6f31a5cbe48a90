#pragma once

#include "experiments/scenario/scenario.hpp"

#include <filesystem>

namespace evbal {

/// How the draws are played, which changes nothing of what they come to.
struct DrawsStage {
  bool over_bus = false;  ///< one after another; else several at a time, without processes of their own
  bool quiet = false;
};

/// Plays the scenario's day with every draw of its faults, under each of its controllers, and prints how the metrics
/// are spread. Into `folder`:
///
///     runs.csv              a row a draw and controller, as days.csv of a sweep; `faults` names the draw
///     distribution.csv      controller, metric, min, q1, median, q3, p90, max, mean, and without faults
///     runs.sqlite           the same as tables, with the steps of every run
///
/// and, for each controller, in `folder` or in one of its name below:
///
///     worst.yaml            the draw that was worst by the first metric that is expected, or lost most passengers;
///                           a resolved scenario
///     without-faults        the day that all draws are held against
///
/// Throws Error{run_failed} if a day fails, Error{expectation_failed} saying how often an expectation did not hold.
void play_draws(const Scenario& scenario, const std::filesystem::path& folder, const DrawsStage& stage);

}  // namespace evbal

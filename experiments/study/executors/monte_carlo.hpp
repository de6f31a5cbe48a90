#pragma once

#include "experiments/scenario/scenario.hpp"
#include "experiments/study/statistics/distribution.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// How the draws are played, which changes nothing of what they come to.
struct DrawsStage {
  bool over_bus = false;  ///< one after another; else several at a time, without processes of their own
  bool quiet = false;
};

/// How a metric is spread over the draws, and its value without faults.
struct DrawnMetric {
  std::string name;
  Distribution distribution;
  double without = 0.0;
};

/// What the draws came to under one controller.
struct DrawnController {
  std::string controller;
  std::size_t draws = 0;
  std::vector<DrawnMetric> metrics;  ///< those that may be expected
  std::string worst;                 ///< name of the worst draw
  std::string worst_metric;          ///< by which it is
  double worst_value = 0.0;
  std::filesystem::path worst_file;  ///< that draw as a resolved scenario
};

struct DrawsResult {
  std::vector<DrawnController> controllers;
  std::string disappointments;  ///< how often which expectation did not hold; empty if all held
};

/// Plays the scenario's day with every draw of its faults, under each of its controllers. Into `folder`:
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
/// Throws Error{run_failed} if a day fails.
DrawsResult play_draws(const Scenario& scenario, const std::filesystem::path& folder, const DrawsStage& stage);

}  // namespace evbal

#pragma once

#include "experiments/run/twins.hpp"
#include "experiments/scenario/scenario.hpp"
#include "experiments/study/executors/play_days.hpp"
#include "experiments/study/statistics/distribution.hpp"
#include "experiments/study/statistics/fault_influence.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// How the draws are played, none of which changes their results.
struct DrawsStage {
  bool over_bus = false;      ///< one after another; else several at a time, each in one process
  OnDayEnded on_day_ended{};  ///< is told of each day
};

/// How a metric is spread over the draws, and its value without faults.
struct DrawnMetric {
  std::string name;           ///< of the metric
  Distribution distribution;  ///< over the draws
  double without = 0.0;       ///< value without faults
};

/// What the draws came to under one controller.
struct DrawnController {
  std::string controller;                   ///< its name
  std::size_t draws = 0;                    ///< that were played
  std::vector<DrawnMetric> metrics;         ///< those that may be expected
  std::string worst;                        ///< name of the worst draw
  std::string worst_metric;                 ///< by which it is
  double worst_value = 0.0;                 ///< of the metric
  std::filesystem::path worst_file;         ///< that draw as a resolved scenario
  bool largest_is_worst = true;             ///< of the metric
  std::vector<double> values{};             ///< of the metric in each draw
  std::vector<DrawnQuantity> quantities{};  ///< what differs between the draws
  std::vector<Influence> influences{};      ///< of these on the metric, the strongest first
};

/// What all draws came to.
struct DrawsResult {
  std::vector<DrawnController> controllers;  ///< in the scenario's order
  std::string disappointments;               ///< how often which expectation did not hold; empty if all held
};

/// A day that is played with every draw of its faults, under each of its controllers.
struct Draws {
  std::vector<Run> runs;          ///< one a controller
  Sweep sweep;                    ///< every draw of every run as a day
  std::vector<std::string> keys;  ///< of the days (day_keys.hpp)

  /// Differs if any of the days does.
  std::string fingerprint() const;
};

/// The draws of the scenario, to be recorded in `folder`. Throws Error{bad_input}.
Draws draws_of(const Scenario& scenario, const std::filesystem::path& folder);

/// The file in the folder in which the draws' results gather (store/sweep_file.hpp).
std::filesystem::path draws_file(const std::filesystem::path& folder);

/// Plays the draws that have no result in the folder yet. Into `folder`:
///
///     runs.csv              a row a draw and controller, as days.csv of a sweep; `faults` names the draw
///     distribution.csv      controller, metric, min, q1, median, q3, p90, max, mean, and without faults
///     influence.csv         how the metric of the worst draw goes with what was drawn (draws_page.hpp)
///     draws.md              the same in words and tables, with the worst draws
///     runs.sqlite           the same as tables, with the steps of every run
///
/// and, for each controller, in `folder` or in one of its name below:
///
///     worst.yaml            the draw that was worst by the first metric that is expected, or lost most passengers;
///                           a resolved scenario
///     without-faults        the day without faults, with which all draws are compared
///
/// Throws Error{run_failed} if a day fails; the others keep their results.
DrawsResult play_draws(const Draws& draws, const std::filesystem::path& folder, const DrawsStage& stage);

}  // namespace evbal

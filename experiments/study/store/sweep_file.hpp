#pragma once

#include "common/clock.hpp"
#include "experiments/metrics/day_result.hpp"
#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/design/sweep.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

/// sweep.sqlite, in which a sweep's results gather:
///
///     days      run, scenario, variant, controller, faults, day, seed, the settings by path, key      what is to be
///     run results   key, the totals by the names of metrics/columns.hpp, fallbacks, digest      a row a finished day
///     steps     key, start, the columns of steps.csv                                        its steps
///     origin    what it was made from (sweep_origin.hpp)
///
/// `run` counts from 1. `key` is a fingerprint of the day's resolved scenario: a result serves every sweep that asks
/// for the same day. Each function opens the file anew, so that processes may add to it in turn.
namespace evbal {

/// Makes the file if it is missing and writes down what is to be run, with a key for each of the sweep's days, in place
/// of what was to be run before. Gives the keys that have their results already. Throws Error{bad_input} if the file is
/// something else or of another version.
std::set<std::string> begin_sweep(const std::filesystem::path& file, const Sweep& sweep,
                                  const std::vector<std::string>& keys);

/// Adds a day, whole or not at all, durably.
void add_result(const std::filesystem::path& file, const std::string& key, const DayClock& clock,
                const DayResult& result);

/// Makes the file, if it is missing, with tables for results and nothing to be run. Throws SQLite's exception if it is
/// something else.
void begin_results(const std::filesystem::path& file);

/// Adds the results of another such file, whole or not at all, durably; those of a key that has its result are left
/// out.
void merge_result(const std::filesystem::path& file, const std::filesystem::path& other);

/// days.csv: a row a day of the sweep with its settings and totals, by `run`.
std::string swept_days_csv(const std::filesystem::path& file);

/// steps.csv: a row a step of every day, `run` first.
std::string swept_steps_csv(const std::filesystem::path& file);

/// The days of a finished sweep, by `run`. Throws Error{bad_input} if there is no sweep or a day of it is missing.
std::vector<FinishedDay> read_finished(const std::filesystem::path& file);

}  // namespace evbal

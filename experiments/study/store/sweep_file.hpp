#pragma once

#include "common/clock.hpp"
#include "experiments/metrics/day_result.hpp"
#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/design/sweep.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// A database in which the results of many days gather: sweep.sqlite of a sweep, tuning.sqlite of the tuning that it
/// may need first, runs.sqlite of a schedule's draws. Its tables:
///
///     days      a row a day that is asked for: run, scenario, variant, controller, faults, day, seed, the settings by
///               path, key
///     results   a row a finished day: key, the totals by the names of metrics/columns.hpp, fallbacks, program, digest
///     steps     a row a step of a finished day: key, start, the columns of steps.csv
///     failed    a row a day that failed when it was played last: key, reason
///     timings   a row a finished day: key, seconds that it took; of no result
///     origin    what the sweep is made from (sweep_origin.hpp)
///
/// `run` counts from 1. `key` is a fingerprint of all that a day's result comes from (executors/day_keys.hpp): a result
/// serves whoever asks for the same day. `program` says who played it (common/version.hpp). Each function opens the
/// file anew, so that processes may add to it in turn.
namespace evbal {

/// Makes the file if it is missing and writes down the days that are asked for, with a key for each, in place of those
/// that were asked for before. Gives the keys that have their results already. Throws
/// Error{bad_input} if the file is something else or of another version.
std::set<std::string> begin_sweep(const std::filesystem::path& file, const Sweep& sweep,
                                  const std::vector<std::string>& keys);

/// Adds a day, whole or not at all, durably.
void add_result(const std::filesystem::path& file, const std::string& key, const DayClock& clock,
                const DayResult& result);

/// Notes why a day failed, in place of why it failed before. It counts as long as the day has no result.
void note_failure(const std::filesystem::path& file, const std::string& key, const std::string& reason);

/// By key why days without a result failed; none if there is no file. Throws Error{bad_input} as begin_sweep.
std::map<std::string, std::string> failures_in(const std::filesystem::path& file);

/// failed.csv: a row a day of the sweep that failed and has no result, with its settings and the reason, by `run`;
/// empty if there is none.
std::string failed_days_csv(const std::filesystem::path& file);

/// Notes how long the playing of a day took, to foresee how long others will.
void note_seconds(const std::filesystem::path& file, const std::string& key, double seconds);

/// The keys that have their results, with the seconds that these took where they are known; none if there is no file.
/// Throws Error{bad_input} as begin_sweep.
std::map<std::string, std::optional<double>> seconds_of_results(const std::filesystem::path& file);

/// Makes the file, if it is missing, with tables for results; no days are asked for. Throws Error{bad_input} as
/// begin_sweep.
void begin_results(const std::filesystem::path& file);

/// Adds the results of another such file, whole or not at all, durably; those of a key that has its result are left
/// out.
void merge_result(const std::filesystem::path& file, const std::filesystem::path& other);

/// Results in a file that another program than this one played: another version of evbal, or another build.
struct PlayedByAnother {
  std::string program;  ///< version and build
  int asked_for = 0;    ///< results that have one of the keys
  int others = 0;       ///< results that have none
};

/// Those in the file, by program; none if there is no file. Throws Error{bad_input} as begin_sweep.
std::vector<PlayedByAnother> played_by_others(const std::filesystem::path& file, const std::vector<std::string>& keys);

/// days.csv: a row a day of the sweep with its settings and totals, by `run`.
std::string swept_days_csv(const std::filesystem::path& file);

/// steps.csv: a row a step of every day, `run` first.
std::string swept_steps_csv(const std::filesystem::path& file);

/// What of the days that were asked for is played.
struct PlayedDays {
  std::vector<FinishedDay> days;     ///< those with a result, by `run`
  std::vector<FinishedDay> missing;  ///< those without, which have no totals
  std::string first_missing;         ///< the `run` of the first of these
};

/// The days of a sweep that have their results, which may go on. Throws Error{bad_input} if there is no such file.
PlayedDays read_played(const std::filesystem::path& file);

/// The days that were asked for, by `run`, with their results; those that have none have no totals. Throws
/// Error{bad_input} if there is no such file.
std::vector<FinishedDay> read_asked_for(const std::filesystem::path& file);

/// The days that were asked for with their results, by `run`. Throws Error{bad_input} if there is no such file, or a
/// day has no result.
std::vector<FinishedDay> read_finished(const std::filesystem::path& file);

}  // namespace evbal

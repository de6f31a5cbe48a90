#pragma once

#include "common/digest.hpp"
#include "common/legs.hpp"
#include "experiments/metrics/metrics.hpp"
#include "experiments/record/day_file.hpp"
#include "experiments/scenario/input_digests.hpp"
#include "experiments/scenario/network_conditions.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace evbal {

/// What is known of a run before its first tick.
struct RunHeader {
  std::string scenario;                        ///< its name
  std::string resolved;                        ///< scenario.resolved.yaml as text
  InputDigests inputs{};                       ///< of pack and model
  std::string date;                            ///< of the day, ISO 8601
  std::uint64_t seed = 0;                      ///< of the run
  std::string controller;                      ///< its name
  std::string engine;                          ///< its name
  std::string transport;                       ///< "dds" or "inproc"
  std::optional<NetworkConditions> network{};  ///< of a network that loses packets
  std::filesystem::path dds_profiles{};        ///< file of settings of Fast DDS; empty: none
  bool security = false;                       ///< whether processes had to prove themselves, and all was encrypted
  MetricsFrame frame;                          ///< what the metrics need
  std::vector<std::string> region_names;       ///< by region
  std::vector<RequestedFault> faults;          ///< in the order of the schedule
};

/// How the objectives of plans differ from those of the same plans by another engine.
struct CrossChecked {
  std::string engine;       ///< name of the other one
  int plans = 0;            ///< that both solved
  int unsolved = 0;         ///< that the other one did not bring to an optimum
  double difference = 0.0;  ///< over those that both solved, the largest |a - b| / max(1, |b|), b by the other one
};

/// What a finished run came to.
struct RunResult {
  std::filesystem::path folder;               ///< of the run
  std::string controller;                     ///< its name
  std::string digest;                         ///< of all that was said
  Totals totals;                              ///< of the day
  int fallbacks = 0;                          ///< plans that were not the controller's own
  double wall_seconds = 0.0;                  ///< from the start to the end of the last tick
  std::optional<CrossChecked> cross_check{};  ///< if plans were solved again
};

/// A run's directory, written while the day goes on:
///
///     scenario.resolved.yaml   the scenario with everything explicit; runs as it is
///     run.sqlite               what was said (day_file.hpp)
///     steps.csv, regions.csv   one row a step, one a step and region (metrics.hpp)
///     summary.json             what it came to (summary.hpp)
///     INCOMPLETE               until mark_complete(): how far the run came
///     without-faults           its twin, faults.csv what the faults cost (paired_run.hpp)
///
/// If no tick was recorded when the object dies, what it created is removed again.
class RunRecord {
 public:
  /// Creates the directory. Throws Error{bad_input} if there are files in it, or it cannot be made.
  RunRecord(std::filesystem::path folder, RunHeader header);
  ~RunRecord();
  RunRecord(const RunRecord&) = delete;
  RunRecord& operator=(const RunRecord&) = delete;

  /// The run's directory.
  const std::filesystem::path& folder() const { return folder_; }

  /// Adds the next tick.
  void add(const TickRecord& record);

  /// The scenario has one more fault, at the end of its schedule, and now reads `resolved`.
  void amend(const std::string& resolved, const RequestedFault& fault);

  /// Notes why the run breaks off here, among the events of the tick that did not end, if the file can still be
  /// written.
  void break_off(const std::string& why);

  /// What was added.
  std::span<const TickRecord> ticks() const { return ticks_; }

  /// Writes what is still missing but for what others add, who call mark_complete() at last. All steps of the day must
  /// have been added; `timings` are what the legs of the ticks took.
  RunResult finish(const std::vector<ProcessLegs>& timings, const std::optional<CrossChecked>& cross_check = {});

 private:
  using Clock = std::chrono::steady_clock;

  void note_events(const TickRecord& record);
  void note_not_injected();
  void mark_incomplete() const;

  std::filesystem::path folder_;
  RunHeader header_;
  bool created_folder_;
  DayFile file_;
  Digest digest_;
  std::vector<TickRecord> ticks_;
  std::vector<double> tick_seconds_;  ///< wall time of each tick, without writing it down
  Clock::time_point start_;
  Clock::time_point last_;
  bool finished_ = false;
};

/// Takes the mark INCOMPLETE from a run's directory, to which nothing is to be added any more.
void mark_complete(const std::filesystem::path& folder);

/// The digest of a day: faults, reports, plan and departures of every tick, in this order.
std::string digest_of(const std::vector<TickRecord>& ticks);

}  // namespace evbal

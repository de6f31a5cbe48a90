#pragma once

#include "experiments/metrics/recovery.hpp"
#include "experiments/record/recorded_run.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// A run with faults and its twin, the same without: the run directory `without-faults` in its own.
namespace evbal {

/// Where the twin of the run in `folder` is recorded.
std::filesystem::path twin_folder(const std::filesystem::path& folder);

/// What the faults cost by one metric.
struct MetricCost {
  std::string metric;  ///< a column of steps.csv
  FaultCost cost;      ///< of all faults
};

/// What the faults of `run` cost, of each of costed_metrics(). `twin` is of the same clock.
std::vector<MetricCost> costs_of(const RecordedRun& run, const RecordedRun& twin);

/// Writes what costs_of says into the run's faults.csv and, as key `without_faults`, its summary.json.
///
///     faults.csv       metric, with, without, cost, area, signed_area, band, recovered_min, and
///                      recovered_min:NAME of each fault; empty if the recovery was not seen before the
///                      day ended
///     without_faults   digest of the twin; metrics, by name, of the same fields, the faults' under by_fault;
///                      null for what faults.csv leaves empty
void write_costs(const RecordedRun& run, const RecordedRun& twin, const std::vector<MetricCost>& costs);

}  // namespace evbal

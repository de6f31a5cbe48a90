#pragma once

#include "common/workers.hpp"
#include "experiments/run/record_day.hpp"

#include <filesystem>
#include <vector>

namespace evbal {

/// A scenario under one of its controllers, and where it is recorded.
struct Run {
  Scenario scenario;
  std::filesystem::path folder;
};

/// A run for each controller: in `folder`, or if there are several, in one of its name below.
std::vector<Run> runs_of(const Scenario& scenario, const std::filesystem::path& folder);

/// Plays the run by its scenario's transport. Throws as record_day.
RunResult record(const Run& run, bool quiet);

/// The same runs without faults, which a process of its own plays and records meanwhile.
class Twins {
 public:
  /// Starts it. No other thread may run.
  explicit Twins(const std::vector<Run>& runs);

  /// Waits until all are there. Throws Error{run_failed}.
  void await();

 private:
  Workers worker_;
};

}  // namespace evbal

#pragma once

#include "experiments/metrics/metrics.hpp"
#include "experiments/run/stepped_day.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace evbal {

/// What happened in a region since the last step, and how it stands.
struct RegionChange {
  Flows flows;    ///< since the last step
  Stocks stocks;  ///< now
};

/// A fault that was seen to act since the last step.
struct SeenFault {
  std::string name;     ///< in the schedule
  int region = 0;       ///< in which it was seen, no_region if it acts on none
  double amount = 0.0;  ///< see Observed
};

/// Days of a scenario, one after the other, stepped from plan to plan and rewarded.
class Environment {
 public:
  /// `reward`: weights of metrics by name, those that reward_metrics() gives. Throws Error{bad_input}.
  Environment(const Scenario& scenario, const std::map<std::string, double>& reward);

  /// Begins a day of this seed; `date` is one of the city's days, or empty for the day of before. Throws
  /// Error{bad_input}.
  void begin(std::uint64_t seed, const std::string& date);

  /// Makes the plan and goes on, as SteppedDay::step. Throws Error{run_failed} also if there is no day to be stepped:
  /// it was not begun, is over, or broke off.
  void step(Plan plan);

  /// What is played, or will be.
  const Scenario& scenario() const { return scenario_; }

  /// The day under way, to be shared with its controllers. Throws Error{run_failed} if none was begun.
  const std::shared_ptr<SteppedDay>& day() const;

  /// The changes of the last step, by region; once the last plan is made, up to the day's end.
  const std::vector<RegionChange>& changes() const { return changes_; }

  /// The faults that were seen in it.
  const std::vector<SeenFault>& seen_faults() const { return seen_; }

  /// Its reward: the sum of the metrics, each by its weight.
  double reward() const { return reward_; }

 private:
  void take_changes();
  void note_seen(const TickRecord& record);

  Scenario scenario_;
  std::map<std::string, double> weights_;
  std::shared_ptr<SteppedDay> day_;
  bool broken_ = false;
  std::size_t taken_ = 0;  ///< of the day's ticks
  std::vector<RegionChange> changes_;
  std::vector<SeenFault> seen_;
  double reward_ = 0.0;
};

/// The flows by their names (metrics/columns.hpp), and `idle_km`; low-battery km weigh `beta` in it.
std::vector<std::pair<std::string, double>> named_flows(const Flows& flows, double beta);

/// The names of metrics that a reward can be made of: those that add up from step to step.
std::vector<std::string> reward_metrics();

}  // namespace evbal

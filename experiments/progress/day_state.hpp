#pragma once

#include "agents/protocol/tick_record.hpp"
#include "common/clock.hpp"

#include <deque>
#include <string>
#include <vector>

namespace evbal {

/// A day as far as it has come.
struct DayState {
  int ticks = 0;                      ///< that are over
  long served = 0;                    ///< passengers so far
  long lost = 0;                      ///< passengers so far
  std::vector<long> demand{};         ///< passengers who appeared in the last step, by region
  std::vector<long> vacant{};         ///< vehicles, by region
  std::vector<long> queue{};          ///< low-battery vehicles that are not charging, by region
  std::vector<long> waiting{};        ///< passengers, by region
  std::vector<std::string> faults{};  ///< that are active, by name
  int planned_at = 0;                 ///< minute of the last plan
  Provenance provenance{};            ///< of the last plan; `controller` is empty before the first
};

/// Follows a day from tick to tick.
class DayWatch {
 public:
  /// `fault_names` by position in the schedule.
  DayWatch(DayClock clock, std::vector<std::string> fault_names);

  /// Takes the next tick.
  void add(const TickRecord& record);

  /// The schedule has one more fault.
  void add_fault(const std::string& name) { fault_names_.push_back(name); }

  /// After the last tick.
  const DayState& state() const { return state_; }

 private:
  void count(const Departures& said);
  void name_faults(const std::vector<Effect>& effects);
  void sum_demand();

  DayClock clock_;
  std::vector<std::string> fault_names_;
  std::deque<std::vector<long>> demand_;  ///< of each of the last step's ticks, by region
  DayState state_;
};

}  // namespace evbal

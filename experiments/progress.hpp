#pragma once

#include "common/clock.hpp"
#include "experiments/conductor/players.hpp"

#include <chrono>
#include <set>
#include <string>
#include <vector>

namespace evbal {

/// "43 s" or "12 min 5 s".
std::string shown_seconds(double seconds);

/// Shows on stderr how far a day has come: one line that renews itself on a terminal, else a line every simulated hour.
class Progress {
 public:
  /// `fault_names` by position in the schedule.
  Progress(std::string title, DayClock clock, std::vector<std::string> fault_names, bool quiet);

  /// Ends the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const TickRecord& record);

 private:
  std::string line(const TickRecord& record) const;

  std::string title_;
  DayClock clock_;
  std::vector<std::string> fault_names_;
  bool quiet_;
  bool terminal_;
  bool line_open_ = false;
  std::chrono::steady_clock::time_point start_;
  std::set<int> active_;  ///< faults seen since the last line
  long served_ = 0;
  long lost_ = 0;
};

}  // namespace evbal

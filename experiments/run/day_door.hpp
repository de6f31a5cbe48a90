#pragma once

#include "experiments/conductor/players.hpp"
#include "experiments/record/run_record.hpp"
#include "experiments/run/day_request.hpp"
#include "experiments/run/request_box.hpp"
#include "experiments/scenario/scenario.hpp"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// How a day goes on.
struct DayPace {
  int tick = 0;                            ///< that comes next
  bool paused = false;                     ///< until somebody lets it go on
  std::optional<double> speed{};           ///< simulated time by the wall's clock, at most; none: as fast as it can
  std::vector<PlayerProcess> processes{};  ///< as Players has them

  /// Field by field.
  bool operator==(const DayPace&) const = default;
};

/// What a day takes from outside, and whom it tells.
struct DoorOptions {
  std::optional<double> speed{};                     ///< as in DayPace, to begin with
  std::function<void(const Fault&)> on_fault = {};   ///< hears of each fault that is added, before its first tick
  std::function<void(const DayPace&)> on_pace = {};  ///< hears of each change
};

/// The door to a day that goes on: requests from outside (day_request.hpp, which come as request_box.hpp says) are
/// answered between two ticks. A fault that is added begins at the next tick and becomes part of the scenario in the
/// run's directory, of its record, and of `faults.yaml` there, a schedule for other days: a replay needs to know
/// nothing of how it came.
class DayDoor {
 public:
  /// The day that goes on, all of which must outlive the door.
  struct Day {
    const Scenario& scenario;  ///< as it began
    Schedule& schedule;        ///< which the players follow, and to which faults are added
    Players& players;          ///< of the day
    RunRecord& record;         ///< of the day
  };

  /// Opens the door of the day that is recorded in the directory of `day.record`.
  DayDoor(const Day& day, DoorOptions options);

  /// Answers what has been asked, and waits as long as the day is paused or ahead of its pace. Throws
  /// Error{run_failed} if interrupted meanwhile.
  void before_tick(int tick);

 private:
  using Clock = std::chrono::steady_clock;

  std::string answer(const std::string& request);
  std::string add_fault(const YamlValue& entry);
  bool may_go_on() const;
  void tell();

  Day day_;
  DoorOptions options_;
  RequestBox box_;
  DayPace pace_;
  std::optional<DayPace> told_;
  int steps_ = 0;          ///< ticks that may be played though the day is paused
  Clock::time_point due_;  ///< when the tick is due by the pace
};

}  // namespace evbal

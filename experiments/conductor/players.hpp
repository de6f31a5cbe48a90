#pragma once

#include "agents/protocol/tick_record.hpp"
#include "common/legs.hpp"

#include <map>
#include <string>
#include <vector>

namespace evbal {

/// How a schedule takes a process away.
enum class Absence { killed, paused };

/// Processes that are away, by name: "agent-3", "coordinator", "faults".
using Absences = std::map<std::string, Absence>;

/// A process of the run, between two ticks.
struct PlayerProcess {
  std::string name;   ///< "agent-3", "coordinator", "faults"
  int id = 0;         ///< of the process; 0 while it is gone
  bool there = true;  ///< it is running, and on the bus

  /// Field by field.
  bool operator==(const PlayerProcess&) const = default;
};

/// Everybody but the conductor: agents, coordinator and injector, as processes on the bus or as objects in this one.
class Players {
 public:
  virtual ~Players() = default;

  /// The injector's word on `tick`.
  virtual Faults faults(int tick) = 0;

  /// Regions that one agent hosts: region r is of "agent-<r / this>".
  virtual int regions_per_process() const { return 1; }

  /// Takes these processes away, and brings back those that were away and are not among them.
  virtual void take_away(const Absences& /*away*/) {}

  /// Announces the tick and gives back what was said, all that is due. Throws Error{run_failed} naming whom it
  /// waited for in vain.
  virtual Exchange play(const Tick& tick) = 0;

  /// The schedule has been amended: its fault at this position begins at the next tick.
  virtual void amended(int /*fault*/) {}

  /// While the day stands still between two ticks: brings back processes that died, and lets all know that the
  /// conductor is there.
  virtual void stand_still() {}

  /// The processes other than this one, if there are any.
  virtual std::vector<PlayerProcess> processes() const { return {}; }

  /// Ends a process as a `kill -9` from outside does, which the run survives. Throws Error{bad_input} if there is none
  /// of that name.
  virtual void kill(const std::string& name);

  /// Times the legs of a tick in the conductor's process.
  Legs& legs() { return legs_; }

  /// Ends the others, who play no more, and says what the legs of everybody's ticks took, the conductor's first.
  virtual std::vector<ProcessLegs> end() { return {{"conductor", legs_.taken()}}; }

 private:
  Legs legs_;
};

}  // namespace evbal

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

  /// Times the legs of a tick in the conductor's process.
  Legs& legs() { return legs_; }

  /// Ends the others, who play no more, and says what the legs of everybody's ticks took, the conductor's first.
  virtual std::vector<ProcessLegs> end() { return {{"conductor", legs_.taken()}}; }

 private:
  Legs legs_;
};

}  // namespace evbal

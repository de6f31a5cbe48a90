#pragma once

#include "agents/protocol/messages.hpp"

#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// What befell a process of the run, for the record: it changes nothing of what is said.
struct Incident {
  std::string kind;  ///< "process ended", "process back"
  std::string what;
};

/// What the others said in one tick.
struct Exchange {
  std::vector<Report> reports;         ///< by region; empty where no plan is due
  std::optional<Plan> plan;            ///< where one is due
  std::vector<Departures> departures;  ///< by region
  std::vector<Incident> incidents;     ///< since the last tick; no part of the digest
};

/// One tick as the conductor saw it.
struct TickRecord {
  Faults faults;
  Tick tick;
  Exchange exchange;
};

/// Everybody but the conductor: agents, coordinator and injector, as processes on the bus or as objects in this one.
class Players {
 public:
  virtual ~Players() = default;

  /// The injector's word on `tick`.
  virtual Faults faults(int tick) = 0;

  /// Announces the tick and gives back what was said, all that is due. Throws Error{run_failed} naming whom it
  /// waited for in vain.
  virtual Exchange play(const Tick& tick) = 0;
};

}  // namespace evbal

#pragma once

#include "agents/protocol/messages.hpp"

#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// What befell the run's processes or its bus, for the record: it changes nothing of what is said.
struct Incident {
  std::string kind;  ///< "process ended", "process back", "sample refused"
  std::string what;  ///< in a sentence
};

/// What the others said in one tick.
struct Exchange {
  std::vector<Report> reports;         ///< by region; empty where no plan is due
  std::optional<Plan> plan;            ///< where one is due
  std::vector<Departures> departures;  ///< by region
  std::vector<Incident> incidents;     ///< since the last tick; no part of the digest
};

/// What the conductor saw a fault of processes or of the network do in a tick.
struct Seen {
  std::int32_t region = 0;  ///< no_region if it acts on none
  Observed observed;        ///< amount: 1 for a tick of absence, or samples that were not in time
};

/// One tick as the conductor saw it.
struct TickRecord {
  Faults faults;           ///< what the injector said
  Tick tick;               ///< what the conductor said
  Exchange exchange;       ///< what the others said
  std::vector<Seen> seen;  ///< in the order of the effects
};

}  // namespace evbal

#include "experiments/record/events.hpp"

#include "agents/protocol/words.hpp"

namespace evbal {

std::set<int> active_faults(const TickRecord& record) {
  std::set<int> active;
  for (const auto& effect : record.faults.effects) {
    active.insert(effect.fault);
  }
  return active;
}

std::vector<Incident> events_of(const TickRecord& record, const TickRecord* before,
                                const std::vector<std::string>& fault_names) {
  std::vector<Incident> events;
  const auto now = active_faults(record);
  const auto then = before == nullptr ? std::set<int>{} : active_faults(*before);
  const auto name = [&](int fault) { return fault_names.at(static_cast<std::size_t>(fault)); };
  for (const int fault : now) {
    if (!then.contains(fault)) {
      events.push_back({"fault begins", name(fault)});
    }
  }
  for (const int fault : then) {
    if (!now.contains(fault)) {
      events.push_back({"fault ends", name(fault)});
    }
  }
  if (record.exchange.plan) {
    const Provenance& made = record.exchange.plan->provenance;
    if (made.fallback != FallbackLevel::none) {
      events.push_back({"fallback", std::string(word(made.fallback)) + ": " + made.reason});
    }
    for (const Rejection& rejection : made.rejected) {
      events.push_back({"report rejected", "region " + std::to_string(rejection.region) + ": " + rejection.reason});
    }
  }
  // Last: a replay has the others alone, numbered alike.
  events.insert(events.end(), record.exchange.incidents.begin(), record.exchange.incidents.end());
  return events;
}

}  // namespace evbal

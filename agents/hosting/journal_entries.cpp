#include "agents/hosting/journal_entries.hpp"

#include "agents/bus/cdr.hpp"

#include <algorithm>

namespace evbal {
namespace {

/// The message as a reader for these regions takes it from the bus.
template <class Message>
Message as_heard(const Message& message, const RegionRange& regions) {
  const Sample<Message> sample{.run = {}, .message = message};
  std::string bytes(cdr_size(sample), '\0');
  write_cdr(sample, bytes.data());
  return read_cdr<Message>(bytes, regions).message;
}

}  // namespace

bool waits_for_plan(const Tick& tick, const RegionRange& regions) {
  const auto planned = [&](int region) {
    return regions.contains(region) && std::ranges::find(tick.unplanned, region) == tick.unplanned.end();
  };
  return tick.plan_due && !tick.unattended && std::any_of(tick.due.begin(), tick.due.end(), planned);
}

AgentEntry agent_entry(const Tick& tick, const Plan* plan, const RegionRange& regions) {
  AgentEntry entry{.tick = as_heard(tick, regions), .plan = {}};
  if (plan != nullptr && waits_for_plan(tick, regions)) {
    entry.plan.push_back(as_heard(*plan, regions));
  }
  return entry;
}

}  // namespace evbal

#include "faults/schedule/guard.hpp"

#include "faults/schedule/fault_types.hpp"
#include "faults/schedule/target.hpp"

#include <algorithm>
#include <numeric>

namespace evbal {
namespace {

/// With the line that asked for it, if a file did.
std::string line_of(const PlacedFault& placed) {
  const int line = placed.where.line();
  return "`" + placed.fault.name + "`" + (line > 0 ? " (line " + std::to_string(line) + ")" : "");
}

/// Whether two faults exclude each other where they meet: of a type and of one field or topic, or of one process.
bool exclusive(const Fault& a, const Fault& b) {
  const bool processes = family_of(a.type) == FaultFamily::process && family_of(b.type) == FaultFamily::process;
  return processes ? a.process == b.process
                   : a.type == b.type && a.field == b.field &&
                         (a.topic == b.topic || a.topic == NetworkTopic::all || b.topic == NetworkTopic::all);
}

void check_pair(const PlacedFault& earlier, const PlacedFault& later, const DayClock& clock) {
  const Fault& a = earlier.fault;
  const Fault& b = later.fault;
  if (a.name == b.name) {
    throw later.where.error("fault " + line_of(later) + " has the name of " + line_of(earlier) +
                            "; give each a name of its own");
  }
  if (const auto both = overlap(a, b, clock)) {
    const std::string what = a.type == b.type ? "both are " + fault_type(a.type).name + " in " : "both act on ";
    throw later.where.error("fault " + line_of(later) + " overlaps " + line_of(earlier) + ": " + what +
                            place_name(a, both->region) + " from " + time_of_day(clock, clock.minute_of(both->from)) +
                            " to " + time_of_day(clock, clock.minute_of(both->to)) +
                            "; move one in time or to other regions");
  }
}

void check_tick(const Guard& guard, std::span<const PlacedFault> faults, const FaultContext& context, int tick) {
  const PlacedFault* last = nullptr;
  const PlacedFault* last_outage = nullptr;
  int active = 0;
  double working = std::accumulate(context.points_per_region.begin(), context.points_per_region.end(), 0.0);
  for (const auto& placed : faults) {
    if (!tick_window(placed.fault, context.clock).holds(tick)) {
      continue;
    }
    ++active;
    last = &placed;
    if (placed.fault.type == EffectType::charger_outage) {
      last_outage = &placed;
      working -= std::accumulate(placed.fault.magnitudes.begin(), placed.fault.magnitudes.end(), 0.0);
    }
  }
  const std::string at = " at " + time_of_day(context.clock, context.clock.minute_of(tick));
  if (active > guard.max_active) {
    throw last->where.error("with fault " + line_of(*last) + " " + std::to_string(active) + " faults are active" + at +
                            "; the guard's max_active allows " + std::to_string(guard.max_active));
  }
  if (last_outage != nullptr && working < guard.min_working_points) {
    throw last_outage->where.error("fault " + line_of(*last_outage) + " leaves " +
                                   std::to_string(static_cast<int>(working)) + " charging points working" + at +
                                   "; the guard's min_working_points asks for " +
                                   std::to_string(guard.min_working_points));
  }
}

}  // namespace

std::optional<Overlap> overlap(const Fault& a, const Fault& b, const DayClock& clock) {
  const TickWindow first = tick_window(a, clock);
  const TickWindow second = tick_window(b, clock);
  const int from = std::max(first.first, second.first);
  const int to = std::min({first.last, second.last, clock.ticks()});
  if (!exclusive(a, b) || from >= to) {
    return std::nullopt;
  }
  const auto shared = std::find_first_of(a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end());
  return shared == a.regions.end() ? std::nullopt : std::optional(Overlap{*shared, from, to});
}

Guard read_guard(const YamlValue& value) {
  YamlMap map(value);
  Guard guard;
  if (const auto given = map.find("max_active")) {
    guard.max_active = given->integer(1, 1000);
  }
  if (const auto given = map.find("min_working_points")) {
    guard.min_working_points = given->integer(0, 1'000'000);
  }
  if (const auto given = map.find("overlap")) {
    given->one_of({"reject"});
  }
  map.finish();
  return guard;
}

void check_guard(const Guard& guard, std::span<const PlacedFault> faults, const FaultContext& context) {
  for (std::size_t later = 0; later < faults.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      check_pair(faults[earlier], faults[later], context.clock);
    }
  }
  for (int tick = 0; tick < context.clock.ticks(); ++tick) {
    check_tick(guard, faults, context, tick);
  }
}

bool keeps_guard(const Guard& guard, const std::vector<Fault>& faults, const FaultContext& context) {
  const YamlValue nowhere = YamlValue::parse("{}", "faults");
  std::vector<PlacedFault> placed;
  placed.reserve(faults.size());
  for (const auto& fault : faults) {
    placed.push_back({fault, nowhere});
  }
  try {
    check_guard(guard, placed, context);
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace evbal

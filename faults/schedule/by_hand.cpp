#include "faults/schedule/by_hand.hpp"

#include "faults/schedule/draw.hpp"
#include "faults/schedule/guard.hpp"
#include "faults/schedule/request.hpp"

#include <algorithm>

namespace evbal {
namespace {

/// The first name "by-hand-N" that no fault has.
std::string free_name(const Schedule& schedule) {
  for (int number = 1;; ++number) {
    std::string name = "by-hand-" + std::to_string(number);
    if (std::ranges::none_of(schedule.faults, [&](const Fault& fault) { return fault.name == name; })) {
      return name;
    }
  }
}

/// The entry as a schedule would have it.
YamlValue begun_at(const YamlValue& entry, const std::string& time, const std::string& name) {
  const auto value = [&](const std::string& text) { return YamlValue::parse_option('"' + text + '"', entry.file()); };
  YamlMap map(entry);
  for (const char* key : {"start", "arrivals"}) {
    if (const auto given = map.find(key)) {
      throw given->error(std::string("a fault by hand begins at the next tick; leave `") + key + "` out");
    }
  }
  const YamlValue begun = entry.with("start", value(time));
  return map.find("name") ? begun : begun.with("name", value(name));
}

void check_injector(const Schedule& schedule, const YamlValue& entry, const DayClock& clock, int tick) {
  for (const Fault& fault : schedule.faults) {
    const TickWindow window = tick_window(fault, clock);
    if (family_of(fault.type) == FaultFamily::process && fault.process == ProcessRole::injector && window.holds(tick)) {
      throw entry.error("the injector is away or late until " + time_of_day(clock, clock.minute_of(window.last)) +
                        ", by fault `" + fault.name + "`; no other fault can begin before");
    }
  }
}

}  // namespace

Schedule with_fault_by_hand(Schedule schedule, const YamlValue& entry, const FaultContext& context, int tick) {
  check_injector(schedule, entry, context.clock, tick);
  const std::string time = time_of_day(context.clock, context.clock.minute_of(tick));
  const Request request = read_request(begun_at(entry, time, free_name(schedule)), context);
  const Fault fault = draw_faults(request, context, {schedule.seed, 0}).front();
  const YamlValue nowhere = YamlValue::parse_option("{}", entry.file());
  std::vector<PlacedFault> placed;
  for (const Fault& earlier : schedule.faults) {
    placed.push_back({earlier, nowhere});
  }
  placed.push_back({fault, entry});
  check_guard(schedule.guard, placed, context);
  schedule.faults.push_back(fault);
  return schedule;
}

}  // namespace evbal

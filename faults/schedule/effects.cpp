#include "faults/schedule/fault_types.hpp"
#include "faults/schedule/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

int nearest_tick(int minute, const DayClock& clock) {
  return (2 * minute + clock.tick) / (2 * clock.tick);
}

/// Share of its full magnitude that a fault has in the middle of a tick.
double strength(const Fault& fault, const TickWindow& window, const DayClock& clock, int tick) {
  if (fault.ramp == 0) {
    return 1.0;
  }
  const double since_start = (tick + 0.5 - window.first) * clock.tick;
  const double until_end = (window.last - tick - 0.5) * clock.tick;
  return std::min(1.0, std::min(since_start, until_end) / fault.ramp);
}

}  // namespace

TickWindow tick_window(const Fault& fault, const DayClock& clock) {
  const int first = std::min(nearest_tick(fault.start, clock), clock.ticks() - 1);
  return {first, std::max(first + 1, nearest_tick(fault.start + fault.duration, clock))};
}

Faults faults_at(const Schedule& schedule, const DayClock& clock, int tick) {
  Faults faults;
  faults.tick = tick;
  for (std::size_t index = 0; index < schedule.faults.size(); ++index) {
    const Fault& fault = schedule.faults[index];
    const TickWindow window = tick_window(fault, clock);
    if (!window.holds(tick)) {
      continue;
    }
    const double share = strength(fault, window, clock, tick);
    const double neutral = fault_type(fault.type).neutral;
    const bool absence = fault.type == EffectType::process_kill || fault.type == EffectType::process_pause ||
                         fault.type == EffectType::host_down;
    for (std::size_t i = 0; i < fault.regions.size(); ++i) {
      faults.effects.push_back(
          {.fault = static_cast<std::int32_t>(index),
           .type = fault.type,
           .region = fault.regions[i],
           .magnitude = absence ? window.last - tick : std::lerp(neutral, fault.magnitudes[i], share),
           .on_start = fault.on_start,
           .visible = fault.visible,
           .to = fault.to,
           .field = fault.field,
           .process = fault.process,
           .topic = fault.topic});
    }
  }
  return faults;
}

}  // namespace evbal

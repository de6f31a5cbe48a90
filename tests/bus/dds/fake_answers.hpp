#pragma once

#include "agents/protocol/messages.hpp"

#include <vector>

/// What stand-ins for agents, coordinator and injector say: something that depends on what they were told, in the
/// sizes of a real day, so that a test can tell whether it came through whole.
namespace evbal::fake {

constexpr int deadly_tick = 1001;  ///< of which the agent of region 1 dies, however often it is told

inline Faults faults(int tick) {
  return {.tick = tick,
          .effects = {{.fault = tick % 3, .type = EffectType::charger_outage, .region = 1, .magnitude = 0.5 * tick}},
          .origin = {}};
}

inline Tick tick(int tick, int regions) {
  Tick message;
  message.tick = tick;
  message.plan_due = tick % 2 == 0;
  for (int region = 0; region < regions; ++region) {
    message.due.push_back(region);
    message.arrivals.push_back({.region = region, .minute = 5 * tick, .vehicle = {.id = region}});
    message.under_way.push_back({.region = region, .minute = 5 * tick + 7, .count = 2});
  }
  return message;
}

inline Report report(int tick, int region) {
  return {.tick = tick,
          .region = region,
          .vacant = 10 + (tick + region) % 5,
          .plugged_since = std::vector<int>(4, tick),
          .reach_m = {},
          .bound = std::vector<UnderWay>(6, {.region = region, .minute = tick, .count = 1}),
          .origin = {}};
}

inline Plan plan(const Tick& tick, const std::vector<Report>& reports) {
  Plan message;
  message.tick = tick.tick;
  message.provenance.controller = "fake";
  for (const auto& report : reports) {
    message.moves.push_back({.from = report.region, .to = 0, .count = report.vacant});
  }
  return message;
}

/// Counts in `refused` the vehicles that the plan sends from here.
inline Departures departures(const Tick& tick, const Plan* plan, int region) {
  Departures message;
  message.tick = tick.tick;
  message.region = region;
  message.departures.assign(4, {.minute = tick.tick, .to = region, .vehicle = {.id = region}, .km = 3.5});
  message.fates.assign(4, {.appeared = tick.tick, .waited = 3, .served = true, .vehicle = region});
  if (plan != nullptr) {
    for (const auto& move : plan->moves) {
      message.refused += move.from == region ? move.count : 0;
    }
  }
  return message;
}

}  // namespace evbal::fake

#pragma once

#include "experiments/record/run_record.hpp"

namespace evbal {

inline Report small_report(int tick, int region, int vacant = 0, int low_battery = 0, int plugged = 0) {
  Report report;
  report.tick = tick;
  report.region = region;
  report.vacant = vacant;
  report.low_battery = low_battery;
  report.plugged = plugged;
  report.points = region == 1 ? 2 : 0;
  return report;
}

inline Departures small_departures(int tick, int region) {
  Departures said;
  said.tick = tick;
  said.region = region;
  said.points = region == 1 ? 2 : 0;
  return said;
}

inline Plan small_plan(int tick) {
  Plan plan;
  plan.tick = tick;
  plan.provenance.controller = "nominal";
  plan.provenance.engine = "ipopt";
  plan.provenance.iterations = 7;
  return plan;
}

/// A day of two regions, two steps of 10 min, four ticks of 5 min, a plan every 10 min, worked out by hand. Region 1
/// has two charging points. Six vehicles: 3 vacant at region 0; 1 vacant, 1 low-battery and 1 plugged at region 1.
///
///     tick 0  region 0 serves a passenger, loses one and sends a vacant car to region 1 (4 km)
///     tick 1  both arrive; a session ends at region 1
///     tick 2  region 1 sends a low-battery car to region 0 (2 km); one of its points is out
///     tick 3  nothing sets off
inline std::vector<TickRecord> small_day() {
  const auto car = [](int id) { return Vehicle{.id = id, .sessions = 0, .battery_kwh = 20.0}; };
  std::vector<TickRecord> day(4);
  for (int t = 0; t < 4; ++t) {
    auto& record = day[static_cast<std::size_t>(t)];
    record.faults.tick = t;
    record.tick.tick = t;
    record.tick.plan_due = t % 2 == 0;
    record.exchange.departures = {small_departures(t, 0), small_departures(t, 1)};
    if (record.tick.plan_due) {
      record.exchange.reports = {small_report(t, 0), small_report(t, 1)};
      record.exchange.plan = small_plan(t);
    }
  }
  const auto at = [&day](std::size_t tick, std::size_t region) -> Departures& {
    return day[tick].exchange.departures[region];
  };
  const auto stand = [&at](std::size_t tick, std::size_t region, int vacant, int low_battery, int plugged) {
    at(tick, region).vacant = vacant;
    at(tick, region).low_battery = low_battery;
    at(tick, region).plugged = plugged;
  };

  day[0].exchange.reports = {small_report(0, 0, 3), small_report(0, 1, 1, 1, 1)};
  day[0].exchange.plan->moves = {{.from = 0, .to = 1, .count = 1, .errand = Errand::rebalance}};
  at(0, 0).demand = 4;
  at(0, 0).departures = {
      {.minute = 0, .to = 1, .arrival_minute = 6, .errand = Errand::rebalance, .vehicle = car(0), .km = 4.0},
      {.minute = 2, .to = 1, .arrival_minute = 8, .errand = Errand::passenger, .vehicle = car(1), .km = 4.5}};
  at(0, 0).fates = {{.appeared = 0, .destination = 1, .waited = 2, .served = true, .vehicle = 1},
                    {.appeared = 1, .destination = 0, .waited = 3, .served = false, .vehicle = -1}};
  at(0, 1).queue_minutes = 5;
  stand(0, 0, 1, 0, 0);
  stand(0, 1, 1, 1, 1);

  day[1].tick.arrivals = {{.region = 1, .minute = 6, .errand = Errand::rebalance, .vehicle = car(0)},
                          {.region = 1, .minute = 8, .errand = Errand::passenger, .vehicle = car(1)}};
  at(1, 1).demand = 1;
  at(1, 1).completions = 1;
  stand(1, 0, 1, 0, 0);
  stand(1, 1, 4, 1, 0);

  day[2].exchange.reports = {small_report(2, 0, 1), small_report(2, 1, 4, 1)};
  day[2].faults.effects = {{.fault = 0, .type = EffectType::charger_outage, .region = 1, .magnitude = 1.0}};
  at(2, 1).observed = {{.fault = 0, .amount = 1.0, .evicted = 0}};
  at(2, 1).departures = {
      {.minute = 10, .to = 0, .arrival_minute = 17, .errand = Errand::charge, .vehicle = car(5), .km = 2.0}};
  stand(2, 0, 1, 0, 0);
  stand(2, 1, 4, 0, 0);

  day[3].tick.arrivals = {{.region = 0, .minute = 17, .errand = Errand::charge, .vehicle = car(5)}};
  at(3, 0).fates = {{.appeared = 4, .destination = 1, .waited = 11, .served = false, .vehicle = -1}};
  stand(3, 0, 1, 1, 0);
  stand(3, 1, 4, 0, 0);
  return day;
}

inline DayClock small_clock() {
  return {.start = 300, .end = 320, .tick = 5, .step = 10, .plan_every = 10};
}

inline RunHeader small_header() {
  return {.scenario = "small",
          .resolved = "seed: 7\n",
          .date = "2008-06-03",
          .seed = 7,
          .controller = "nominal",
          .engine = "ipopt",
          .transport = "inproc",
          .frame = {.clock = small_clock(), .points = {0, 2}, .beta = 0.5},
          .region_names = {"west", "east, upper"},
          .faults = {{.name = "outage", .type = "charger.outage", .start = 10, .end = 15}}};
}

}  // namespace evbal

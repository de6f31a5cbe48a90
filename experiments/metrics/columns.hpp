#pragma once

#include "experiments/metrics/metrics.hpp"

/// The numbers of each row by name, in the order of the files: `visit("name", value)`.
namespace evbal {

/// Of what adds up over time.
template <class Visit>
void columns(Visit&& visit, const Flows& f) {
  visit("demand", f.demand);
  visit("served", f.served);
  visit("lost", f.lost);
  visit("wait_minutes", f.wait_minutes);
  visit("completions", f.completions);
  visit("queue_minutes", f.queue_minutes);
  visit("stranded", f.stranded);
  visit("refused", f.refused);
  visit("rebalance_moves", f.rebalance_moves);
  visit("charge_moves", f.charge_moves);
  visit("top_ups", f.top_ups);
  visit("rebalance_km", f.rebalance_km);
  visit("charge_km", f.charge_km);
  visit("passenger_km", f.passenger_km);
  visit("charged_kwh", f.charged_kwh);
}

/// Of how things stand at a step's end.
template <class Visit>
void columns(Visit&& visit, const Stocks& s) {
  visit("vacant", s.vacant);
  visit("low_battery", s.low_battery);
  visit("plugged", s.plugged);
  visit("points", s.points);
  visit("waiting", s.waiting);
  visit("broken", s.broken);
}

/// Of the unfairness.
template <class Visit>
void columns(Visit&& visit, const Unfairness& u) {
  visit("unfairness_demand", u.demand);
  visit("unfairness_charging", u.charging);
  visit("unfairness_demand_shares", u.demand_shares);
  visit("unfairness_charging_shares", u.charging_shares);
  visit("unfairness_demand_drop_offs", u.demand_drop_offs);
}

/// Of a row of regions.csv.
template <class Visit>
void columns(Visit&& visit, const RegionStep& r) {
  visit("step", r.step);
  visit("region", r.region);
  columns(visit, r.flows);
  columns(visit, r.stocks);
  visit("supply", r.supply);
  visit("low_battery_present", r.low_battery_present);
}

/// Of a row of steps.csv.
template <class Visit>
void columns(Visit&& visit, const CityStep& c) {
  visit("step", c.step);
  visit("idle_km", c.idle_km);
  columns(visit, c.unfairness);
  columns(visit, c.flows);
  columns(visit, c.stocks);
  visit("under_way", c.under_way);
}

/// Of a day's totals.
template <class Visit>
void columns(Visit&& visit, const Totals& t) {
  visit("idle_km", t.idle_km);
  columns(visit, t.unfairness);
  columns(visit, t.flows);
  visit("unserved_ratio", t.unserved_ratio);
  visit("p90_regional_loss", t.p90_regional_loss);
  visit("passenger_wait_min", t.passenger_wait_min);
  visit("charger_wait_min", t.charger_wait_min);
  visit("charger_wait_min_per_session", t.charger_wait_min_per_session);
  visit("idle_km_per_served", t.idle_km_per_served);
  visit("sensor_lies", t.detection.lies);
  visit("lies_seen_60", t.detection.seen_60);
  visit("lies_found_30", t.detection.found_30);
  visit("lies_found_60", t.detection.found_60);
  visit("lies_found", t.detection.found);
  visit("lies_found_minutes", t.detection.minutes);
  visit("large_lies", t.detection.large);
  visit("large_lies_found_60", t.detection.large_found_60);
  visit("false_alarms", t.detection.false_alarms);
}

}  // namespace evbal

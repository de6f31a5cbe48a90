#pragma once

#include "agents/protocol/messages.hpp"

#include <concepts>
#include <type_traits>

/// The fields of each message by name, for whoever walks over them: the digest, the record, the comparison of two
/// runs. `visit("name", field)` is called once per field in the order of the struct; a field is a number, an enum,
/// a bool, a text, a message again, or a vector of these. Works for const and mutable messages.
namespace evbal {

template <class Given, class Message>
concept Is = std::same_as<std::remove_cvref_t<Given>, Message>;

/// A field that is quiet on most days: a visitor with a function `rare` of its own may leave it out then.
template <class Visit, class Field>
void rare(Visit& visit, const char* name, Field& field, bool quiet) {
  if constexpr (requires { visit.rare(name, field, quiet); }) {
    visit.rare(name, field, quiet);
  } else {
    visit(name, field);
  }
}

template <class Visit>
void fields(Visit&& visit, Is<Origin> auto& m) {
  visit("process_id", m.process_id);
  visit("seconds", m.seconds);
}

template <class Visit>
void fields(Visit&& visit, Is<Vehicle> auto& m) {
  visit("id", m.id);
  visit("sessions", m.sessions);
  visit("battery_kwh", m.battery_kwh);
}

template <class Visit>
void fields(Visit&& visit, Is<Arrival> auto& m) {
  visit("region", m.region);
  visit("minute", m.minute);
  visit("errand", m.errand);
  visit("vehicle", m.vehicle);
}

template <class Visit>
void fields(Visit&& visit, Is<UnderWay> auto& m) {
  visit("region", m.region);
  visit("minute", m.minute);
  visit("errand", m.errand);
  visit("count", m.count);
}

template <class Visit>
void fields(Visit&& visit, Is<Effect> auto& m) {
  visit("fault", m.fault);
  visit("type", m.type);
  visit("region", m.region);
  visit("magnitude", m.magnitude);
  visit("on_start", m.on_start);
  visit("visible", m.visible);
  rare(visit, "to", m.to, m.to == no_region);
  rare(visit, "field", m.field, m.field == ReportField::none);
  rare(visit, "process", m.process, m.process == ProcessRole::agent);
  rare(visit, "topic", m.topic, m.topic == NetworkTopic::all);
}

template <class Visit>
void fields(Visit&& visit, Is<Faults> auto& m) {
  visit("tick", m.tick);
  visit("effects", m.effects);
  visit("origin", m.origin);
}

template <class Visit>
void fields(Visit&& visit, Is<Tick> auto& m) {
  visit("tick", m.tick);
  visit("plan_due", m.plan_due);
  visit("due", m.due);
  visit("unheard", m.unheard);
  visit("unplanned", m.unplanned);
  visit("unattended", m.unattended);
  visit("arrivals", m.arrivals);
  visit("under_way", m.under_way);
  visit("effects", m.effects);
}

template <class Visit>
void fields(Visit&& visit, Is<Report> auto& m) {
  visit("tick", m.tick);
  visit("region", m.region);
  visit("vacant", m.vacant);
  visit("low_battery", m.low_battery);
  visit("plugged", m.plugged);
  visit("points", m.points);
  visit("waiting", m.waiting);
  visit("demand", m.demand);
  visit("completions", m.completions);
  visit("plugged_since", m.plugged_since);
  visit("bound", m.bound);
  visit("origin", m.origin);
}

template <class Visit>
void fields(Visit&& visit, Is<Move> auto& m) {
  visit("from", m.from);
  visit("to", m.to);
  visit("count", m.count);
  visit("errand", m.errand);
}

template <class Visit>
void fields(Visit&& visit, Is<Rejection> auto& m) {
  visit("region", m.region);
  visit("reason", m.reason);
}

template <class Visit>
void fields(Visit&& visit, Is<Provenance> auto& m) {
  visit("controller", m.controller);
  visit("engine", m.engine);
  visit("fallback", m.fallback);
  visit("reason", m.reason);
  visit("objective", m.objective);
  visit("lower_bound", m.lower_bound);
  visit("gap", m.gap);
  visit("max_violation", m.max_violation);
  visit("iterations", m.iterations);
  rare(visit, "demand_widened", m.demand_widened, m.demand_widened == 1.0);
  rare(visit, "completions_widened", m.completions_widened, m.completions_widened == 1.0);
  rare(visit, "rejected", m.rejected, m.rejected.empty());
}

template <class Visit>
void fields(Visit&& visit, Is<Plan> auto& m) {
  visit("tick", m.tick);
  visit("moves", m.moves);
  visit("provenance", m.provenance);
  visit("origin", m.origin);
}

template <class Visit>
void fields(Visit&& visit, Is<Departure> auto& m) {
  visit("minute", m.minute);
  visit("to", m.to);
  visit("arrival_minute", m.arrival_minute);
  visit("errand", m.errand);
  visit("vehicle", m.vehicle);
  visit("km", m.km);
}

template <class Visit>
void fields(Visit&& visit, Is<Fate> auto& m) {
  visit("appeared", m.appeared);
  visit("destination", m.destination);
  visit("waited", m.waited);
  visit("served", m.served);
  visit("vehicle", m.vehicle);
}

template <class Visit>
void fields(Visit&& visit, Is<Observed> auto& m) {
  visit("fault", m.fault);
  visit("amount", m.amount);
  visit("evicted", m.evicted);
}

template <class Visit>
void fields(Visit&& visit, Is<Departures> auto& m) {
  visit("tick", m.tick);
  visit("region", m.region);
  visit("departures", m.departures);
  visit("fates", m.fates);
  visit("observed", m.observed);
  visit("refused", m.refused);
  visit("demand", m.demand);
  visit("completions", m.completions);
  visit("queue_minutes", m.queue_minutes);
  visit("stranded", m.stranded);
  visit("charged_kwh", m.charged_kwh);
  visit("vacant", m.vacant);
  visit("low_battery", m.low_battery);
  visit("plugged", m.plugged);
  visit("points", m.points);
  visit("waiting", m.waiting);
  rare(visit, "broken", m.broken, m.broken == 0);
  visit("origin", m.origin);
}

}  // namespace evbal

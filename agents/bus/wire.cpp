#include "agents/bus/wire.hpp"

#include "agents/protocol/fields.hpp"
#include "common/error.hpp"

#include <type_traits>

namespace evbal {
namespace {

// One list of pairs for each type serves both directions: `copy(own, wire)` is ToWire or FromWire below.

template <class Copy>
void pairs(const Copy& copy, Is<Origin> auto& own, auto& wire) {
  copy(own.process_id, wire.process_id());
  copy(own.seconds, wire.seconds());
}

template <class Copy>
void pairs(const Copy& copy, Is<Vehicle> auto& own, auto& wire) {
  copy(own.id, wire.id());
  copy(own.sessions, wire.sessions());
  copy(own.battery_kwh, wire.battery_kwh());
}

template <class Copy>
void pairs(const Copy& copy, Is<Arrival> auto& own, auto& wire) {
  copy(own.region, wire.region());
  copy(own.minute, wire.minute());
  copy(own.errand, wire.errand());
  copy(own.vehicle, wire.vehicle());
}

template <class Copy>
void pairs(const Copy& copy, Is<UnderWay> auto& own, auto& wire) {
  copy(own.region, wire.region());
  copy(own.minute, wire.minute());
  copy(own.errand, wire.errand());
  copy(own.count, wire.count());
}

template <class Copy>
void pairs(const Copy& copy, Is<Effect> auto& own, auto& wire) {
  copy(own.fault, wire.fault());
  copy(own.type, wire.type());
  copy(own.region, wire.region());
  copy(own.magnitude, wire.magnitude());
  copy(own.on_start, wire.on_start());
  copy(own.visible, wire.visible());
  copy(own.to, wire.to());
  copy(own.field, wire.field());
  copy(own.process, wire.process());
  copy(own.topic, wire.topic());
}

template <class Copy>
void pairs(const Copy& copy, Is<Hello> auto& own, auto& wire) {
  copy(own.name, wire.name());
  copy(own.process_id, wire.process_id());
}

template <class Copy>
void pairs(const Copy& copy, Is<Faults> auto& own, auto& wire) {
  copy(own.tick, wire.tick());
  copy(own.effects, wire.effects());
  copy(own.origin, wire.origin());
}

template <class Copy>
void pairs(const Copy& copy, Is<Tick> auto& own, auto& wire) {
  copy(own.tick, wire.tick());
  copy(own.plan_due, wire.plan_due());
  copy(own.due, wire.due());
  copy(own.unheard, wire.unheard());
  copy(own.unplanned, wire.unplanned());
  copy(own.unattended, wire.unattended());
  copy(own.arrivals, wire.arrivals());
  copy(own.under_way, wire.under_way());
  copy(own.effects, wire.effects());
}

template <class Copy>
void pairs(const Copy& copy, Is<Report> auto& own, auto& wire) {
  copy(own.tick, wire.tick());
  copy(own.region, wire.region());
  copy(own.vacant, wire.vacant());
  copy(own.low_battery, wire.low_battery());
  copy(own.plugged, wire.plugged());
  copy(own.points, wire.points());
  copy(own.waiting, wire.waiting());
  copy(own.demand, wire.demand());
  copy(own.completions, wire.completions());
  copy(own.plugged_since, wire.plugged_since());
  copy(own.bound, wire.bound());
  copy(own.origin, wire.origin());
}

template <class Copy>
void pairs(const Copy& copy, Is<Move> auto& own, auto& wire) {
  copy(own.from, wire.from());
  copy(own.to, wire.to());
  copy(own.count, wire.count());
  copy(own.errand, wire.errand());
}

template <class Copy>
void pairs(const Copy& copy, Is<Rejection> auto& own, auto& wire) {
  copy(own.region, wire.region());
  copy(own.reason, wire.reason());
}

template <class Copy>
void pairs(const Copy& copy, Is<Provenance> auto& own, auto& wire) {
  copy(own.controller, wire.controller());
  copy(own.engine, wire.engine());
  copy(own.fallback, wire.fallback());
  copy(own.reason, wire.reason());
  copy(own.objective, wire.objective());
  copy(own.lower_bound, wire.lower_bound());
  copy(own.gap, wire.gap());
  copy(own.max_violation, wire.max_violation());
  copy(own.iterations, wire.iterations());
  copy(own.demand_widened, wire.demand_widened());
  copy(own.completions_widened, wire.completions_widened());
  copy(own.rejected, wire.rejected());
}

template <class Copy>
void pairs(const Copy& copy, Is<Plan> auto& own, auto& wire) {
  copy(own.tick, wire.tick());
  copy(own.moves, wire.moves());
  copy(own.provenance, wire.provenance());
  copy(own.origin, wire.origin());
}

template <class Copy>
void pairs(const Copy& copy, Is<Departure> auto& own, auto& wire) {
  copy(own.minute, wire.minute());
  copy(own.to, wire.to());
  copy(own.arrival_minute, wire.arrival_minute());
  copy(own.errand, wire.errand());
  copy(own.vehicle, wire.vehicle());
  copy(own.km, wire.km());
}

template <class Copy>
void pairs(const Copy& copy, Is<Fate> auto& own, auto& wire) {
  copy(own.appeared, wire.appeared());
  copy(own.destination, wire.destination());
  copy(own.waited, wire.waited());
  copy(own.served, wire.served());
  copy(own.vehicle, wire.vehicle());
}

template <class Copy>
void pairs(const Copy& copy, Is<Observed> auto& own, auto& wire) {
  copy(own.fault, wire.fault());
  copy(own.amount, wire.amount());
  copy(own.evicted, wire.evicted());
}

template <class Copy>
void pairs(const Copy& copy, Is<Departures> auto& own, auto& wire) {
  copy(own.tick, wire.tick());
  copy(own.region, wire.region());
  copy(own.departures, wire.departures());
  copy(own.fates, wire.fates());
  copy(own.observed, wire.observed());
  copy(own.refused, wire.refused());
  copy(own.demand, wire.demand());
  copy(own.completions, wire.completions());
  copy(own.queue_minutes, wire.queue_minutes());
  copy(own.stranded, wire.stranded());
  copy(own.charged_kwh, wire.charged_kwh());
  copy(own.vacant, wire.vacant());
  copy(own.low_battery, wire.low_battery());
  copy(own.plugged, wire.plugged());
  copy(own.points, wire.points());
  copy(own.waiting, wire.waiting());
  copy(own.broken, wire.broken());
  copy(own.origin, wire.origin());
}

// Enumerators of each enum count from 0; this is the last one.
constexpr Errand last(Errand /*type*/) {
  return Errand::charge;
}
constexpr EffectType last(EffectType /*type*/) {
  return EffectType::solver_starve;
}
constexpr OnStart last(OnStart /*type*/) {
  return OnStart::evict;
}
constexpr ReportField last(ReportField /*type*/) {
  return ReportField::completions;
}
constexpr ProcessRole last(ProcessRole /*type*/) {
  return ProcessRole::injector;
}
constexpr NetworkTopic last(NetworkTopic /*type*/) {
  return NetworkTopic::plan;
}
constexpr FallbackLevel last(FallbackLevel /*type*/) {
  return FallbackLevel::hold;
}

struct ToWire {
  template <class Own, class Wire>
  void operator()(const Own& own, Wire& wire) const {
    if constexpr (std::is_enum_v<Own>) {
      wire = static_cast<Wire>(own);
    } else if constexpr (std::is_arithmetic_v<Own> || std::is_same_v<Own, std::string>) {
      wire = own;
    } else {
      pairs(*this, own, wire);
    }
  }

  template <class Own, class Wire>
  void operator()(const std::vector<Own>& own, std::vector<Wire>& wire) const {
    wire.resize(own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      (*this)(own[i], wire[i]);
    }
  }
};

struct FromWire {
  template <class Own, class Wire>
  void operator()(Own& own, const Wire& wire) const {
    if constexpr (std::is_enum_v<Own>) {
      if (static_cast<std::uint32_t>(wire) > static_cast<std::uint32_t>(last(Own{}))) {
        throw run_failed("a message on the bus has an enumerator " + std::to_string(static_cast<std::uint32_t>(wire)) +
                         " that does not exist");
      }
      own = static_cast<Own>(wire);
    } else if constexpr (std::is_arithmetic_v<Own> || std::is_same_v<Own, std::string>) {
      own = wire;
    } else {
      pairs(*this, own, wire);
    }
  }

  template <class Own, class Wire>
  void operator()(std::vector<Own>& own, const std::vector<Wire>& wire) const {
    own.resize(wire.size());
    for (std::size_t i = 0; i < wire.size(); ++i) {
      (*this)(own[i], wire[i]);
    }
  }
};

template <class Wire, class Own>
Wire wired(const std::string& run, const Own& message) {
  Wire result;
  result.run(run);
  ToWire{}(message, result);
  return result;
}

template <class Own, class Wire>
Own owned(const Wire& message) {
  Own result;
  FromWire{}(result, message);
  return result;
}

}  // namespace

wire::Hello to_wire(const std::string& run, const Hello& message) {
  return wired<wire::Hello>(run, message);
}

wire::Faults to_wire(const std::string& run, const Faults& message) {
  return wired<wire::Faults>(run, message);
}

wire::Tick to_wire(const std::string& run, const Tick& message) {
  return wired<wire::Tick>(run, message);
}

wire::Reports to_wire(const std::string& run, const std::vector<Report>& message) {
  wire::Reports result;
  result.run(run);
  ToWire{}(message, result.regions());
  return result;
}

wire::Plan to_wire(const std::string& run, const Plan& message) {
  return wired<wire::Plan>(run, message);
}

wire::Departures to_wire(const std::string& run, const std::vector<Departures>& message) {
  wire::Departures result;
  result.run(run);
  ToWire{}(message, result.regions());
  return result;
}

Hello from_wire(const wire::Hello& message) {
  return owned<Hello>(message);
}

Faults from_wire(const wire::Faults& message) {
  return owned<Faults>(message);
}

Tick from_wire(const wire::Tick& message) {
  return owned<Tick>(message);
}

std::vector<Report> from_wire(const wire::Reports& message) {
  return owned<std::vector<Report>>(message.regions());
}

Plan from_wire(const wire::Plan& message) {
  return owned<Plan>(message);
}

std::vector<Departures> from_wire(const wire::Departures& message) {
  return owned<std::vector<Departures>>(message.regions());
}

}  // namespace evbal

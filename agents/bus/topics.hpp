#pragma once

#include "agents/bus/participant.hpp"

#include <vector>

/// The topics of evbal.idl.
namespace evbal {

/// Topic of a message: its name, the name of its type, which participants have a say there, and which listen. `latest`
/// is a topic of one writer of which only the newest sample matters.
template <class Message>
struct Topic;

template <>
struct Topic<Hello> {
  static constexpr auto name = "evbal/hello";
  static constexpr auto type = "evbal::wire::Hello";
  static constexpr bool latest = false;
  static constexpr bool has_say(int from) { return from != BusAddress::conductor; }
  static constexpr bool listens(int to) { return to == BusAddress::conductor; }
};

template <>
struct Topic<Faults> {
  static constexpr auto name = "evbal/faults";
  static constexpr auto type = "evbal::wire::Faults";
  static constexpr bool latest = false;
  static constexpr bool has_say(int from) { return from == BusAddress::injector; }
  static constexpr bool listens(int to) { return to == BusAddress::conductor; }
};

template <>
struct Topic<Tick> {
  static constexpr auto name = "evbal/tick";
  static constexpr auto type = "evbal::wire::Tick";
  static constexpr bool latest = true;
  static constexpr bool has_say(int from) { return from == BusAddress::conductor; }
  static constexpr bool listens(int /*to*/) { return true; }
};

template <>
struct Topic<std::vector<Report>> {
  static constexpr auto name = "evbal/reports";
  static constexpr auto type = "evbal::wire::Reports";
  static constexpr bool latest = false;
  static constexpr bool has_say(int from) { return from >= BusAddress::first_agent; }
  static constexpr bool listens(int to) { return to <= BusAddress::coordinator; }
};

template <>
struct Topic<Plan> {
  static constexpr auto name = "evbal/plan";
  static constexpr auto type = "evbal::wire::Plan";
  static constexpr bool latest = true;
  static constexpr bool has_say(int from) { return from == BusAddress::coordinator; }
  static constexpr bool listens(int to) { return to == BusAddress::conductor || to >= BusAddress::first_agent; }
};

template <>
struct Topic<std::vector<Departures>> {
  static constexpr auto name = "evbal/departures";
  static constexpr auto type = "evbal::wire::Departures";
  static constexpr bool latest = false;
  static constexpr bool has_say(int from) { return from >= BusAddress::first_agent; }
  static constexpr bool listens(int to) { return to == BusAddress::conductor; }
};

/// Calls `visit`, which takes any Topic<...> by value, with each of them.
template <class Visit>
void for_each_topic(Visit visit) {
  visit(Topic<Hello>{});
  visit(Topic<Faults>{});
  visit(Topic<Tick>{});
  visit(Topic<std::vector<Report>>{});
  visit(Topic<Plan>{});
  visit(Topic<std::vector<Departures>>{});
}

}  // namespace evbal

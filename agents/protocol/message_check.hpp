#pragma once

#include "agents/protocol/messages.hpp"
#include "common/clock.hpp"

#include <string>

/// Decides which messages cannot be true. Reports are checked here only for what no sensor measures: the coordinator
/// makes an estimate where the rest cannot be true (coordinator/planning/report_check.hpp).
namespace evbal {

/// What bounds the messages of a run.
struct MessageBounds {
  int regions = 0;            ///< of the city
  int vehicles = 0;           ///< of the whole fleet
  double battery_kwh = 0.0;   ///< of each vehicle
  double longest_trip = 0.0;  ///< minutes, between any two regions, on a day without faults
  DayClock clock;             ///< of the run
};

/// What is wrong with a message, in a few words; empty if nothing is. In a message that passes every number is finite
/// and small enough to be counted on with, every text is UTF-8, and every region, minute, vehicle and fault exists.
std::string validate(const Faults& message, const MessageBounds& bounds);
/// The same of a tick.
std::string validate(const Tick& message, const MessageBounds& bounds);
/// The same of a report.
std::string validate(const Report& message, const MessageBounds& bounds);
/// The same of a plan.
std::string validate(const Plan& message, const MessageBounds& bounds);
/// The same of departures.
std::string validate(const Departures& message, const MessageBounds& bounds);

/// Throws Error{run_failed}: what `sender` said of a tick cannot be, and why.
[[noreturn]] void refuse(const std::string& sender, int tick, const std::string& wrong);

/// Throws Error{run_failed} if a message of `sender` does not pass validate().
template <class Message>
void refuse_garbage(const Message& message, const MessageBounds& bounds, const std::string& sender) {
  if (const std::string wrong = validate(message, bounds); !wrong.empty()) {
    refuse(sender, message.tick, wrong);
  }
}

}  // namespace evbal

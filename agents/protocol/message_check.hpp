#pragma once

#include "agents/protocol/messages.hpp"
#include "common/clock.hpp"

#include <string>

/// Nobody on the bus is believed blindly: what cannot be true of a message. Reports, of which the coordinator makes an
/// estimate where one cannot be believed, have a check of their own (coordinator/planning/report_check.hpp).
namespace evbal {

/// What bounds the messages of a run.
struct MessageBounds {
  int regions = 0;            ///< of the city
  int vehicles = 0;           ///< of the whole fleet
  double battery_kwh = 0.0;   ///< of each vehicle
  double longest_trip = 0.0;  ///< minutes, between any two regions, on a day without faults
  DayClock clock;             ///< of the run
};

/// What is wrong with a message, in a few words; empty if nothing is. One that passes holds no region, minute, vehicle
/// or fault that does not exist, no number that is none, and none so large that it could not be counted on with.
std::string complaint(const Faults& message, const MessageBounds& bounds);
/// The same of a tick.
std::string complaint(const Tick& message, const MessageBounds& bounds);
/// The same of a plan.
std::string complaint(const Plan& message, const MessageBounds& bounds);
/// The same of departures.
std::string complaint(const Departures& message, const MessageBounds& bounds);

/// Throws Error{run_failed}: `sender` said of `tick` what is `wrong`.
[[noreturn]] void refuse(const std::string& sender, int tick, const std::string& wrong);

/// Throws Error{run_failed} if there is something wrong with what `sender` said.
template <class Message>
void refuse_garbage(const Message& message, const MessageBounds& bounds, const std::string& sender) {
  if (const std::string wrong = complaint(message, bounds); !wrong.empty()) {
    refuse(sender, message.tick, wrong);
  }
}

}  // namespace evbal

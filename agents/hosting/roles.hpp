#pragma once

#include "agents/bus/participant.hpp"
#include "agents/hosting/process.hpp"

#include <functional>
#include <string>
#include <vector>

/// How each kind of process answers the conductor, tick by tick, until the process is ended. What is said comes from
/// the functions given; these loops add the timing and the origin.
///
/// A process may be killed at any moment and started again. Agents and coordinator journal what they were told before
/// they say what follows from it. One that starts with entries in its journal goes through them once more, repeats its
/// last words, which may not have been heard, and takes its place again. The injector has nothing to remember.
///
/// Each loop throws Error{run_failed}, naming whom it waited for, if that one says nothing within the options'
/// patience.
namespace evbal {

/// A region that an agent hosts. Per tick `begin`, then `report` if a plan is due, then `live`. The same calls give
/// the same answers.
struct HostedRegion {
  /// A tick begins.
  std::function<void(const Tick&)> begin;
  /// The region before anything moves.
  std::function<Report()> report;
  std::function<Departures(const Plan* plan)> live;  ///< plan is null where none is due
};

/// `regions` ascending.
[[noreturn]] void serve_agent(Participant& participant, const ProcessOptions& options,
                              const std::vector<HostedRegion>& regions);

/// Who makes the plans. `recall` stands in place of `plan` in a process that was started again: it is given what
/// `memory` gave after that plan.
struct Planner {
  /// The plan of a tick.
  std::function<Plan(const Tick&, const std::vector<Report>&)> plan;
  /// What later plans need of this one, as bytes.
  std::function<std::string()> memory;
  /// Goes on from such a tick without planning again.
  std::function<void(const Tick&, const std::vector<Report>&, const std::string& memory)> recall;
};

/// Answers as the coordinator, until the process is ended.
[[noreturn]] void serve_coordinator(Participant& participant, const ProcessOptions& options, const Planner& planner);

/// Who says what goes wrong.
struct Schedules {
  /// What is active in a tick. It is asked one tick ahead, so that the conductor does not wait.
  std::function<Faults(int tick)> faults;
  /// Whether there is more to say than before of ticks to come: asked when the conductor says a tick again.
  std::function<bool()> amended = [] { return false; };
};

/// Answers as the injector, until the process is ended.
[[noreturn]] void serve_injector(Participant& participant, const ProcessOptions& options, const Schedules& schedules);

}  // namespace evbal

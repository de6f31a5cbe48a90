#pragma once

#include "agents/bus/participant.hpp"

#include <functional>
#include <string>
#include <vector>

/// How each kind of process answers the conductor, tick by tick, until the process is ended. What is said comes from
/// the functions given; these loops add the timing, the process id and the CPU time.
namespace evbal {

/// The regions that an agent hosts. Per tick `begin`, then `report` if a plan is due, then `live`.
struct HostedRegions {
  std::function<void(const Tick&)> begin;
  std::function<std::vector<Report>()> report;
  std::function<std::vector<Departures>(const Plan* plan)> live;  ///< plan is null where none is due
};

[[noreturn]] void serve_agent(Participant& participant, const std::string& name, const HostedRegions& regions);

/// `plan` gets the reports of all due regions, by region.
[[noreturn]] void serve_coordinator(Participant& participant, const std::string& name,
                                    const std::function<Plan(int tick, const std::vector<Report>&)>& plan);

/// `faults` is asked one tick ahead, so that the conductor does not wait.
[[noreturn]] void serve_injector(Participant& participant, const std::string& name,
                                 const std::function<Faults(int tick)>& faults);

}  // namespace evbal

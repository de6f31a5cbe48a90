#pragma once

#include "agents/bus/participant.hpp"

#include <functional>
#include <string>
#include <vector>

/// How each kind of process answers the conductor, tick by tick, until the process is ended. What is said comes from
/// the functions given; these loops add the timing and the origin.
namespace evbal {

/// A region that an agent hosts. Per tick `begin`, then `report` if a plan is due, then `live`.
struct HostedRegion {
  std::function<void(const Tick&)> begin;
  std::function<Report()> report;
  std::function<Departures(const Plan* plan)> live;  ///< plan is null where none is due
};

/// `regions` ascending.
[[noreturn]] void serve_agent(Participant& participant, const std::string& name,
                              const std::vector<HostedRegion>& regions);

[[noreturn]] void serve_coordinator(Participant& participant, const std::string& name,
                                    const std::function<Plan(const Tick&, const std::vector<Report>&)>& plan);

/// `faults` is asked one tick ahead, so that the conductor does not wait.
[[noreturn]] void serve_injector(Participant& participant, const std::string& name,
                                 const std::function<Faults(int tick)>& faults);

}  // namespace evbal

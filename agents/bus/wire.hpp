#pragma once

#include "agents/bus/hello.hpp"

#include <evbal.h>

#include <string>
#include <vector>

/// Between the structs of the protocol and the types that evbal.idl gives (namespace wire). `from_wire` of
/// `to_wire` is the identity; an enumerator that does not exist throws Error{run_failed}.
namespace evbal {

wire::Hello to_wire(const std::string& run, const Hello& message);
wire::Faults to_wire(const std::string& run, const Faults& message);
wire::Tick to_wire(const std::string& run, const Tick& message);
wire::Reports to_wire(const std::string& run, const std::vector<Report>& message);
wire::Plan to_wire(const std::string& run, const Plan& message);
wire::Departures to_wire(const std::string& run, const std::vector<Departures>& message);

Hello from_wire(const wire::Hello& message);
Faults from_wire(const wire::Faults& message);
Tick from_wire(const wire::Tick& message);
std::vector<Report> from_wire(const wire::Reports& message);
Plan from_wire(const wire::Plan& message);
std::vector<Departures> from_wire(const wire::Departures& message);

}  // namespace evbal

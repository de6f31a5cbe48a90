#include "agents/bus/bus_address.hpp"

namespace evbal {

std::string address_of_host(int host) {
  constexpr int in_a_row = 250;
  return "10.77." + std::to_string(host / in_a_row) + "." + std::to_string(host % in_a_row + 1);
}

std::string name_of(int participant) {
  switch (participant) {
    case BusAddress::conductor:
      return "conductor";
    case BusAddress::coordinator:
      return "coordinator";
    case BusAddress::injector:
      return "faults";
    default:
      return "agent-" + std::to_string(participant - BusAddress::first_agent);
  }
}

}  // namespace evbal

#pragma once

#include <string>

namespace evbal {

/// UDP port for discovery traffic of a participant (RTPS 2.2, section 9.6.1.1); the next one carries its data.
int discovery_port(int domain, int participant);

/// Why no socket of UDP can be bound to the port of one of this host's IPv4 addresses, in the system's words; empty if
/// one can.
std::string port_complaint(const std::string& address, int port);

/// Whether a socket of this process is bound to the UDP port.
bool has_port(int port);

}  // namespace evbal

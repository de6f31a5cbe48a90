#pragma once

#include <string>
#include <vector>

namespace evbal {

/// UDP port for discovery traffic of a participant (RTPS 2.2, section 9.6.1.1); the next one carries its data.
int discovery_port(int domain, int participant);

/// Whether a network interface of this machine has the IPv4 address: of 127.0.0.0/8 few do, though all can be
/// bound to. Throws Error{run_failed} if the interfaces are not to be had.
bool is_own_address(const std::string& address);

/// Why no socket of UDP can be bound to the port of one of this host's IPv4 addresses, in the system's words; empty if
/// one can.
std::string port_complaint(const std::string& address, int port);

/// The IPv4 address of this host from which packets go to all of these; 127.0.0.1 without any. Throws Error{run_failed}
/// if there is no way to one, or if they go from several.
std::string address_towards(const std::vector<std::string>& hosts);

/// Whether a socket of this process is bound to the UDP port.
bool has_port(int port);

}  // namespace evbal

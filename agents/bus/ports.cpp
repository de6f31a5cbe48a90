#include "agents/bus/ports.hpp"

#include "common/error.hpp"

#include <arpa/inet.h>
#include <dirent.h>
#include <ifaddrs.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace evbal {
namespace {

/// The UDP port to which a file of this process is bound; 0 if it is none of IPv4.
int port_of(int file) {
  int type = 0;
  socklen_t size = sizeof type;
  if (getsockopt(file, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_DGRAM) {
    return 0;
  }
  sockaddr_in address{};
  size = sizeof address;
  getsockname(file, reinterpret_cast<sockaddr*>(&address), &size);
  return address.sin_family == AF_INET ? ntohs(address.sin_port) : 0;
}

/// The IPv4 address of this host from which packets go to another.
std::string address_towards(const std::string& host) {
  sockaddr_in there{};
  there.sin_family = AF_INET;
  there.sin_addr.s_addr = inet_addr(host.c_str());
  there.sin_port = htons(1);  // nothing is sent
  sockaddr_in here{};
  socklen_t size = sizeof here;
  const int file = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool found = file >= 0 && connect(file, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0 &&
                     getsockname(file, reinterpret_cast<sockaddr*>(&here), &size) == 0;
  const std::string why = found ? "" : std::strerror(errno);
  if (file >= 0) {
    close(file);
  }
  if (!found) {
    throw run_failed("host " + host + ": no packet can be sent there: " + why);
  }
  std::array<char, INET_ADDRSTRLEN> text{};
  return inet_ntop(AF_INET, &here.sin_addr, text.data(), text.size());
}

Error two_addresses(const std::string& a, const std::string& b, const std::string& own_to_a,
                    const std::string& own_to_b) {
  return run_failed("hosts " + a + " and " + b + " reach this one by two addresses, " + own_to_a + " and " + own_to_b +
                    "; give hosts of one network, this one by its address there, too");
}

}  // namespace

int discovery_port(int domain, int participant) {
  return 7400 + 250 * domain + 10 + 2 * participant;
}

bool is_own_address(const std::string& address) {
  const in_addr_t wanted = inet_addr(address.c_str());
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) {
    throw run_failed(std::string("network interfaces: ") + std::strerror(errno));
  }
  bool found = false;
  for (const ifaddrs* one = all; one != nullptr && !found; one = one->ifa_next) {
    found = one->ifa_addr != nullptr && one->ifa_addr->sa_family == AF_INET &&
            reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr.s_addr == wanted;
  }
  freeifaddrs(all);
  return found;
}

std::string port_complaint(const std::string& address, int port) {
  sockaddr_in wanted{};
  wanted.sin_family = AF_INET;
  wanted.sin_addr.s_addr = inet_addr(address.c_str());
  wanted.sin_port = htons(static_cast<std::uint16_t>(port));
  const int file = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool bound = file >= 0 && bind(file, reinterpret_cast<const sockaddr*>(&wanted), sizeof wanted) == 0;
  std::string complaint = bound ? "" : std::strerror(errno);
  if (file >= 0) {
    close(file);
  }
  return complaint;
}

std::string address_towards(const std::vector<std::string>& hosts) {
  std::string own = "127.0.0.1";
  for (const std::string& host : hosts) {
    const std::string towards = address_towards(host);
    if (&host != &hosts.front() && towards != own) {
      throw two_addresses(hosts.front(), host, own, towards);
    }
    own = towards;
  }
  return own;
}

bool has_port(int port) {
  std::error_code unreadable;
  for (const auto& file : std::filesystem::directory_iterator("/proc/self/fd", unreadable)) {
    if (port_of(std::stoi(file.path().filename())) == port) {
      return true;
    }
  }
  return false;
}

}  // namespace evbal

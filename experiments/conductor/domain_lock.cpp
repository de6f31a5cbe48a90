#include "experiments/conductor/domain_lock.hpp"

#include "agents/bus/ports.hpp"
#include "common/error.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

namespace evbal {
namespace {

constexpr int first_foreign_port = 32768;  // from here on the kernel gives ports to anybody

/// A socket bound to an abstract name is a lock among all that share this host's ports. -1 if somebody has it. Throws
/// Error{run_failed} if there can be none.
int lock(int domain) {
  const std::string name = "evbal-domain-" + std::to_string(domain);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);  // behind a zero byte: no file
  const int file = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  const bool bound = file >= 0 && bind(file, reinterpret_cast<const sockaddr*>(&address), size) == 0;
  const int error = errno;
  if (!bound && file >= 0) {
    close(file);
  }
  if (!bound && error != EADDRINUSE) {
    throw run_failed(std::string("no DDS domain can be locked: ") + std::strerror(error));
  }
  return bound ? file : -1;
}

void release(std::vector<int>& sockets) {
  for (const int file : sockets) {
    close(file);
  }
  sockets.clear();
}

/// Locks `count` domains from `first` on; false if one is taken, with those before it in `sockets`.
bool lock_all(int first, int count, std::vector<int>& sockets) {
  for (int i = 0; i < count; ++i) {
    const int file = lock(first + i);
    if (file < 0) {
      return false;
    }
    sockets.push_back(file);
  }
  return true;
}

}  // namespace

DomainLock::DomainLock(int participants, int from) : participants_(participants) {
  const int block = 1 + (discovery_port(0, participants) - discovery_port(0, 0)) / 250;
  std::string trouble;
  try {
    for (domain_ = from; discovery_port(domain_ + block, 0) < first_foreign_port; ++domain_) {
      const bool locked = lock_all(domain_, block, sockets_);
      trouble = locked ? complaint() : "";
      if (locked && trouble.empty()) {
        return;
      }
      release(sockets_);
    }
  } catch (...) {
    release(sockets_);
    throw;
  }
  throw run_failed("no free DDS domain for " + std::to_string(participants) +
                   " processes; wait for other runs on this host to end" +
                   (trouble.empty() ? "" : " (" + trouble + ")"));
}

std::string DomainLock::complaint() const {
  for (int port = discovery_port(domain_, 0); port < discovery_port(domain_, participants_); ++port) {
    if (const std::string why = port_complaint("127.0.0.1", port); !why.empty()) {
      return "UDP port " + std::to_string(port) + ": " + why;
    }
  }
  return "";
}

DomainLock::~DomainLock() {
  release(sockets_);
}

}  // namespace evbal

#include "experiments/conductor/lossy_network.hpp"

#include "agents/bus/participant.hpp"
#include "common/contract.hpp"
#include "common/error.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

namespace evbal {
namespace {

constexpr auto device = "evbal0";

[[noreturn]] void refuse(const std::string& what) {
  throw bad_input("network: " + what + " (" + std::strerror(errno) +
                  "); losing packets needs network namespaces and /dev/net/tun: run as root, or where user namespaces "
                  "are allowed");
}

int own_namespace() {
  return open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC);
}

/// A new network namespace for this thread; if that takes a privilege that it lacks, in a user namespace that has it.
void enter_new_namespace() {
  if (unshare(CLONE_NEWNET) == 0) {
    return;
  }
  const auto user = std::to_string(geteuid());
  const auto group = std::to_string(getegid());
  if (unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) {
    refuse("no network namespace can be made");
  }
  std::ofstream("/proc/self/setgroups") << "deny";
  std::ofstream("/proc/self/uid_map") << user << ' ' << user << " 1";
  std::ofstream("/proc/self/gid_map") << group << ' ' << group << " 1";
}

/// A request about an interface of this thread's namespace.
ifreq about(const char* name) {
  ifreq request{};
  std::strncpy(request.ifr_name, name, IFNAMSIZ - 1);
  return request;
}

void set_address(ifreq& request, in_addr_t address) {
  sockaddr_in whole{};
  whole.sin_family = AF_INET;
  whole.sin_addr.s_addr = address;
  std::memcpy(&request.ifr_addr, &whole, sizeof whole);
}

void bring_up(int socket, const char* name) {
  ifreq request = about(name);
  request.ifr_flags = IFF_UP | IFF_RUNNING;
  if (ioctl(socket, SIOCSIFFLAGS, &request) != 0) {
    refuse(std::string("the interface ") + name + " does not come up");
  }
}

/// This namespace's device, up, with its address, in a network with all the others.
int make_device(const std::string& address) {
  const int file = open("/dev/net/tun", O_RDWR | O_CLOEXEC | O_NONBLOCK);
  ifreq request = about(device);
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  if (file < 0 || ioctl(file, TUNSETIFF, &request) != 0) {
    refuse("no TUN device can be made");
  }
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  request = about(device);
  set_address(request, inet_addr(address.c_str()));
  bool made = ioctl(socket, SIOCSIFADDR, &request) == 0;
  set_address(request, htonl(0xffff0000));
  made = made && ioctl(socket, SIOCSIFNETMASK, &request) == 0;
  if (!made) {
    refuse("the TUN device takes no address");
  }
  bring_up(socket, device);
  bring_up(socket, "lo");
  close(socket);
  return file;
}

}  // namespace

LossyNetwork::LossyNetwork(const NetworkConditions& conditions, int hosts, std::uint64_t seed)
    : original_(own_namespace()) {
  try {
    for (int host = 0; host <= hosts; ++host) {
      add_host();
    }
  } catch (...) {
    close_all();
    throw;
  }
  setns(namespaces_.front(), CLONE_NEWNET);
  relay_.emplace(ends_, conditions, seed);
}

LossyNetwork::~LossyNetwork() {
  relay_.reset();
  close_all();
}

void LossyNetwork::add_host() {
  enter_new_namespace();
  namespaces_.push_back(own_namespace());
  const std::string address = address_of_host(static_cast<int>(ends_.size()));
  ends_.push_back({.file = make_device(address), .address = ntohl(inet_addr(address.c_str()))});
}

void LossyNetwork::close_all() {
  setns(original_, CLONE_NEWNET);  // fails without privilege: this process stays in the network, which is empty then
  close(original_);
  for (const auto& end : ends_) {
    close(end.file);
  }
  for (const int file : namespaces_) {
    close(file);
  }
}

int LossyNetwork::namespace_of(int host) const {
  EVBAL_EXPECT(host > 0 && host < static_cast<int>(namespaces_.size()), "a host with a namespace of its own");
  return namespaces_[host];
}

InNamespace::InNamespace(int file) {
  if (file >= 0) {
    own_ = own_namespace();
    if (setns(file, CLONE_NEWNET) != 0) {
      close(own_);
      throw run_failed(std::string("a network namespace of the run cannot be entered: ") + std::strerror(errno));
    }
  }
}

InNamespace::~InNamespace() {
  if (own_ >= 0) {
    setns(own_, CLONE_NEWNET);
    close(own_);
  }
}

}  // namespace evbal

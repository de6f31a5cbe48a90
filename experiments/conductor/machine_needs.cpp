#include "experiments/conductor/machine_needs.hpp"

#include <arpa/inet.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>

namespace evbal {
namespace {

constexpr int asked_buffer = 4 * 1024 * 1024;
constexpr int least_buffer = 64 * 1024;  // of Fast DDS, a packet of which is as long
constexpr int bytes_a_message = 640;     // that the kernel counts for a short one
constexpr int least_files = 64;          // of the conductor, which has about 25 open

/// Does a datagram come back over 127.0.0.1?
bool loopback_works() {
  const int receiver = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int sender = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const timeval patience{.tv_sec = 0, .tv_usec = 50'000};
  setsockopt(receiver, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  char byte = 'x';
  const bool works = bind(receiver, generic, size) == 0 && getsockname(receiver, generic, &size) == 0 &&
                     sendto(sender, &byte, 1, 0, generic, size) == 1 && recv(receiver, &byte, 1, 0) == 1;
  close(receiver);
  close(sender);
  return works;
}

/// What the system grants a socket that asks for `option` of asked_buffer bytes.
int granted(int socket, int option) {
  int bytes = asked_buffer;
  socklen_t size = sizeof bytes;
  setsockopt(socket, SOL_SOCKET, option, &bytes, size);
  getsockopt(socket, SOL_SOCKET, option, &bytes, &size);
  return bytes / 2;  // the other half is the system's own account
}

bool may_open(int files) {
  rlimit limit{};
  return getrlimit(RLIMIT_NOFILE, &limit) == 0 && limit.rlim_cur >= static_cast<rlim_t>(files);
}

}  // namespace

int granted_socket_buffer() {
  const int file = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int bytes = std::min(granted(file, SO_RCVBUF), granted(file, SO_SNDBUF));
  close(file);
  return bytes;
}

std::string buffer_complaint(int granted, int processes) {
  if (granted / bytes_a_message >= processes) {
    return "";
  }
  return "socket buffers of " + std::to_string(granted / 1024) + " KiB are granted, too few for a message of each of " +
         std::to_string(processes) +
         " processes: some are lost and sent again, which takes time; allow more by `sysctl -w "
         "net.core.rmem_max=4194304 net.core.wmem_max=4194304`, or fewer processes by `--regions-per-process`";
}

std::vector<Need> machine_needs(const std::filesystem::path& programs) {
  std::vector<Need> needs;
  for (const char* program : {"evbal-agent", "evbal-coordinator", "evbal-faults"}) {
    needs.push_back({program, access((programs / program).c_str(), X_OK) == 0,
                     "is no program in " + programs.string() + "; build or install it there"});
  }
  needs.push_back({std::to_string(least_files) + " open files", may_open(least_files),
                   "fewer are allowed; allow more by `ulimit -n 1024`"});
  if (needs.back().met) {
    needs.push_back({"UDP over 127.0.0.1", loopback_works(),
                     "no datagram comes back; bring the loopback interface up by `ip link set lo up`"});
    needs.push_back({"socket buffers of 64 KiB", granted_socket_buffer() >= least_buffer,
                     "smaller ones are granted; allow more by `sysctl -w net.core.rmem_max=4194304 "
                     "net.core.wmem_max=4194304`"});
  }
  return needs;
}

}  // namespace evbal

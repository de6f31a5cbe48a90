#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// Something that a run over the bus needs of the machine.
struct Need {
  std::string what;  ///< "UDP over 127.0.0.1"
  bool met = false;  ///< whether it is there
  std::string cure;  ///< what is wrong otherwise, and what would be right
};

/// What a run needs of the machine, with its programs in the folder `programs`; takes at most a tenth of a second. Free
/// UDP ports are DomainLock's, /dev/net/tun is LossyNetwork's.
std::vector<Need> machine_needs(const std::filesystem::path& programs);

/// The bytes that a socket of this process may buffer, of the 4 MiB for which the bus asks.
int granted_socket_buffer();

/// What is wrong, and its cure, if sockets that buffer `granted` bytes lose messages when so many processes speak at
/// once; empty if they do not. What is lost is sent again, which takes time.
std::string buffer_complaint(int granted, int processes);

}  // namespace evbal

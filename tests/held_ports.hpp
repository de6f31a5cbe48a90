#pragma once

#include "common/pipe.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>

namespace evbal {

/// UDP ports of 127.0.0.1 in the hands of another process as long as the object lives; those that somebody has already
/// are left out.
class HeldPorts {
 public:
  HeldPorts(int first, int count) : id_(fork()) {
    char byte = 0;
    if (id_ == 0) {
      end_.close_write_end();
      close_others();
      for (int port = first; port < first + count; ++port) {
        take(port);
      }
      [[maybe_unused]] const auto told = write(ready_.write_end(), &byte, 1);
      _exit(static_cast<int>(read(end_.read_end(), &byte, 1)));
    }
    [[maybe_unused]] const auto heard = read(ready_.read_end(), &byte, 1);
  }
  ~HeldPorts() {
    end_.close_write_end();
    waitpid(id_, nullptr, 0);
  }
  HeldPorts(const HeldPorts&) = delete;
  HeldPorts& operator=(const HeldPorts&) = delete;

 private:
  /// Who reads a pipe to its end would wait for this process, too, if it had the other end.
  void close_others() const {
    for (int file = STDERR_FILENO + 1; file < sysconf(_SC_OPEN_MAX) && file < most_files; ++file) {
      if (file != ready_.write_end() && file != end_.read_end()) {
        close(file);
      }
    }
  }

  static void take(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    bind(socket(AF_INET, SOCK_DGRAM, 0), reinterpret_cast<const sockaddr*>(&address), sizeof address);
  }

  static constexpr int most_files = 4096;  ///< that a test has open

  Pipe ready_;
  Pipe end_;  ///< that of the other process
  pid_t id_;
};

}  // namespace evbal

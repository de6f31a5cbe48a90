#pragma once

#include <arpa/inet.h>
#include <linux/if_ether.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace evbal::test {

/// All that passes this network namespace's interfaces, as the wire has it, from the object's beginning until stop().
class Capture {
 public:
  Capture() : socket_(socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC, htons(ETH_P_ALL))) {
    const int buffer = 1 << 26;
    const timeval moment{.tv_sec = 0, .tv_usec = 100'000};
    setsockopt(socket_, SOL_SOCKET, SO_RCVBUFFORCE, &buffer, sizeof buffer);
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &moment, sizeof moment);
    if (allowed()) {
      thread_ = std::thread([this] { listen(); });
    }
  }
  ~Capture() {
    stop();
    close(socket_);
  }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  /// Whether the system lets this process look.
  bool allowed() const { return socket_ >= 0; }

  /// The packets.
  const std::vector<std::string>& stop() {
    stopped_ = true;
    if (thread_.joinable()) {
      thread_.join();
    }
    return packets_;
  }

 private:
  void listen() {
    static thread_local std::array<char, 1 << 17> packet;
    while (!stopped_) {
      const ssize_t size = recv(socket_, packet.data(), packet.size(), 0);
      if (size > 0) {
        packets_.emplace_back(packet.data(), static_cast<std::size_t>(size));
      }
    }
  }

  int socket_;
  std::atomic<bool> stopped_ = false;
  std::vector<std::string> packets_;
  std::thread thread_;
};

}  // namespace evbal::test

#pragma once

#include "tools/console/http.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>

namespace evbal {

/// A connection over which a request of bounded size comes in bounded time: more bytes, or later ones, are the end of
/// it. So it ends for who takes no answers, and for all once `stopping` is set.
class BoundedStream : public httplib::Stream {
 public:
  /// Most bytes of a request, its headers included.
  static constexpr std::size_t most_bytes = 32'768;

  /// Of an open socket. Both must outlive the stream.
  BoundedStream(socket_t socket, const std::atomic<bool>& stopping);

  /// Waits until something can be read, and says whether it can.
  bool is_readable() const override;
  /// Whether the other end is still there.
  bool is_writable() const override;
  /// Bytes of the request, at most `size`: how many, or -1 if no more may come.
  ssize_t read(char* bytes, std::size_t size) override;
  /// All of the bytes, or -1 if nobody takes them.
  ssize_t write(const char* bytes, std::size_t size) override;
  /// Not told: all callers are of this machine.
  void get_remote_ip_and_port(std::string& address, int& port) const override;
  /// Not told.
  void get_local_ip_and_port(std::string& address, int& port) const override;
  /// The connection's.
  socket_t socket() const override { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool awaits(short what, Clock::time_point until) const;
  bool fill();

  socket_t socket_;
  const std::atomic<bool>& stopping_;
  Clock::time_point deadline_;  ///< of the request
  std::array<char, 4096> buffer_{};
  std::size_t begin_ = 0;  ///< of what is in the buffer
  std::size_t end_ = 0;
  std::size_t taken_ = 0;  ///< bytes so far
};

}  // namespace evbal

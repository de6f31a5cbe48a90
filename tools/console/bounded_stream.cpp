#include "tools/console/bounded_stream.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr auto request_time = 5s;   // from the connection to the end of the request
constexpr auto answer_time = 5s;    // for some bytes of the answer to be taken
constexpr auto farewell_time = 1s;  // the same once the server stops
constexpr int glance_ms = 100;      // between looks whether it does

}  // namespace

BoundedStream::BoundedStream(socket_t socket, const std::atomic<bool>& stopping)
    : socket_(socket), stopping_(stopping), deadline_(Clock::now() + request_time) {}

bool BoundedStream::awaits(short what, Clock::time_point until) const {
  const auto begun = Clock::now();
  for (auto now = begun; now < until && !(stopping_ && now > begun + farewell_time); now = Clock::now()) {
    pollfd waited{.fd = socket_, .events = what, .revents = 0};
    if (poll(&waited, 1, glance_ms) > 0) {
      return (waited.revents & what) != 0;
    }
  }
  return false;
}

bool BoundedStream::is_readable() const {
  return begin_ < end_ || awaits(POLLIN, deadline_);
}

bool BoundedStream::is_writable() const {
  pollfd now{.fd = socket_, .events = POLLOUT, .revents = 0};
  return poll(&now, 1, 0) >= 0 && (now.revents & (POLLERR | POLLHUP)) == 0;
}

bool BoundedStream::fill() {
  if (taken_ >= most_bytes || !awaits(POLLIN, deadline_)) {
    return false;
  }
  const ssize_t count = recv(socket_, buffer_.data(), std::min(buffer_.size(), most_bytes - taken_), 0);
  if (count <= 0) {
    return false;
  }
  begin_ = 0;
  end_ = static_cast<std::size_t>(count);
  taken_ += end_;
  return true;
}

ssize_t BoundedStream::read(char* bytes, std::size_t size) {
  if (begin_ == end_ && !fill()) {
    return -1;
  }
  const std::size_t count = std::min(size, end_ - begin_);
  std::memcpy(bytes, buffer_.data() + begin_, count);
  begin_ += count;
  return static_cast<ssize_t>(count);
}

ssize_t BoundedStream::write(const char* bytes, std::size_t size) {
  std::size_t sent = 0;
  while (sent < size) {
    const ssize_t count = send(socket_, bytes + sent, size - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno != EAGAIN || !awaits(POLLOUT, Clock::now() + answer_time)) {
      return -1;
    }
  }
  return static_cast<ssize_t>(sent);
}

void BoundedStream::get_remote_ip_and_port(std::string& address, int& port) const {
  address.clear();
  port = 0;
}

void BoundedStream::get_local_ip_and_port(std::string& address, int& port) const {
  address.clear();
  port = 0;
}

}  // namespace evbal

#include "experiments/conductor/relay.hpp"

#include "common/error.hpp"
#include "common/random.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

namespace evbal {
namespace {

constexpr std::size_t largest_packet = 65536;
constexpr std::size_t least_header = 20;  // of IPv4
constexpr std::size_t destination_at = 16;

/// Where an IPv4 packet is bound for; nothing for anything else.
std::optional<std::uint32_t> destination(const char* packet, std::size_t size) {
  if (size < least_header || (static_cast<unsigned char>(packet[0]) >> 4) != 4) {
    return std::nullopt;
  }
  std::uint32_t address = 0;
  std::memcpy(&address, packet + destination_at, sizeof address);
  return ntohl(address);
}

}  // namespace

Relay::Relay(std::vector<TunEnd> ends, const NetworkConditions& conditions, std::uint64_t seed)
    : ends_(std::move(ends)),
      conditions_(conditions),
      seed_(seed),
      up_(ends_.size(), 0),
      down_(ends_.size(), 0),
      stop_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (stop_ < 0) {
    throw run_failed(std::string("no relay of packets: ") + std::strerror(errno));
  }
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    end_of_[ends_[end].address] = end;
  }
  thread_ = std::thread([this] { carry(); });
}

Relay::~Relay() {
  eventfd_write(stop_, 1);
  thread_.join();
  close(stop_);
}

void Relay::carry() {
  std::vector<pollfd> files;
  for (const auto& end : ends_) {
    files.push_back({.fd = end.file, .events = POLLIN, .revents = 0});
  }
  files.push_back({.fd = stop_, .events = POLLIN, .revents = 0});
  while (files.back().revents == 0) {
    timespec wait{.tv_sec = 1, .tv_nsec = 0};
    if (!on_the_way_.empty()) {
      const auto left = std::max(Clock::duration::zero(), on_the_way_.front().due - Clock::now());
      wait = {.tv_sec = left / std::chrono::seconds(1), .tv_nsec = (left % std::chrono::seconds(1)).count()};
    }
    ppoll(files.data(), files.size(), &wait, nullptr);
    for (std::size_t end = 0; end < ends_.size(); ++end) {
      if (files[end].revents != 0) {
        take_all(end);
      }
    }
    for (; !on_the_way_.empty() && on_the_way_.front().due <= Clock::now(); on_the_way_.pop_front()) {
      const Packet& packet = on_the_way_.front();
      // What a device does not take is lost, as on any network.
      [[maybe_unused]] const auto taken = write(ends_[packet.to].file, packet.bytes.data(), packet.bytes.size());
    }
  }
}

void Relay::take_all(std::size_t from) {
  std::array<char, largest_packet> packet;  // NOLINT(cppcoreguidelines-pro-type-member-init): read fills what is used
  for (;;) {
    const ssize_t size = read(ends_[from].file, packet.data(), packet.size());
    if (size <= 0) {
      return;
    }
    const auto bound = destination(packet.data(), static_cast<std::size_t>(size));
    const auto to = bound ? end_of_.find(*bound) : end_of_.end();
    const bool carried = to != end_of_.end() && (from == 0) != (to->second == 0);
    if (carried && !is_lost(from, to->second)) {
      const auto delay = std::chrono::duration<double, std::milli>(conditions_.delay_ms);
      on_the_way_.push_back({.due = Clock::now() + std::chrono::duration_cast<Clock::duration>(delay),
                             .to = to->second,
                             .bytes = {packet.data(), packet.data() + size}});
    }
  }
}

bool Relay::is_lost(std::size_t from, std::size_t to) {
  const bool up = to == 0;
  std::uint64_t& number = up ? up_[from] : down_[to];
  RandomStream stream(seed_, Purpose::lost_packet,
                      {.region = static_cast<std::uint64_t>(up ? from : to), .tick = up ? 1U : 0U, .index = number++});
  return stream.uniform() < conditions_.loss;
}

}  // namespace evbal

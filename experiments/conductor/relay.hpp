#pragma once

#include "experiments/scenario/network_conditions.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <thread>
#include <vector>

namespace evbal {

/// An end of the network: a TUN device, which gives and takes IPv4 packets, and its address (host byte order).
struct TunEnd {
  int file = -1;  ///< file descriptor of the TUN device
  /// IPv4, host byte order.
  std::uint32_t address = 0;
};

/// Carries packets between the first end and each of the others, in a thread of its own, and loses and delays them on
/// the way. Whether the n-th packet on a way is lost is drawn by (seed, way, n); which packet is the n-th depends on
/// timing and does not repeat. Packets between two of the others, or to anybody else, come nowhere.
class Relay {
 public:
  /// The ends' files do not block. They stay the caller's, and open until the relay is gone.
  Relay(std::vector<TunEnd> ends, const NetworkConditions& conditions, std::uint64_t seed);
  ~Relay();
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

 private:
  void carry();
  void take_all(std::size_t from);
  bool is_lost(std::size_t from, std::size_t to);

  using Clock = std::chrono::steady_clock;

  struct Packet {
    Clock::time_point due;
    std::size_t to = 0;
    std::vector<char> bytes;
  };

  std::vector<TunEnd> ends_;
  NetworkConditions conditions_;
  std::uint64_t seed_;
  std::map<std::uint32_t, std::size_t> end_of_;  ///< by address
  std::vector<std::uint64_t> up_;                ///< packets so far from each end to the first
  std::vector<std::uint64_t> down_;              ///< and from the first to each
  std::deque<Packet> on_the_way_;                ///< all delayed alike: in the order in which they are due
  int stop_ = -1;
  std::thread thread_;
};

}  // namespace evbal

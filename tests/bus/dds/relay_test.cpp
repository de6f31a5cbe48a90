#include "experiments/conductor/relay.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>

namespace evbal {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// Three ends of a network, the first in the middle, as pairs of sockets in place of devices.
class RelayTest : public testing::Test {
 protected:
  RelayTest() {
    for (std::uint32_t end = 0; end < 3; ++end) {
      std::array<int, 2> pair{};
      socketpair(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, pair.data());
      ends_.push_back({.file = pair[0], .address = end + 1});
      ours_.push_back(pair[1]);
    }
  }
  ~RelayTest() override {
    for (std::size_t end = 0; end < ends_.size(); ++end) {
      close(ends_[end].file);
      close(ours_[end]);
    }
  }

  /// An IPv4 packet of nothing but a header that is bound for an address, and a number.
  void send(std::size_t from, std::uint32_t address, char number) const {
    std::array<char, 21> packet{};
    packet[0] = 0x45;
    const std::uint32_t destination = htonl(address);
    std::memcpy(packet.data() + 16, &destination, sizeof destination);
    packet.back() = number;
    ASSERT_EQ(write(ours_[from], packet.data(), packet.size()), 21);
  }

  /// The numbers of the packets that come to an end until nothing comes for a while.
  std::string come(std::size_t to) const {
    std::string numbers;
    pollfd file{.fd = ours_[to], .events = POLLIN, .revents = 0};
    while (poll(&file, 1, 100) > 0) {
      std::array<char, 64> packet{};
      numbers += read(file.fd, packet.data(), packet.size()) == 21 ? packet[20] : '?';
    }
    return numbers;
  }

  std::string a_hundred(const NetworkConditions& conditions, std::uint64_t seed) const {
    const Relay relay(ends_, conditions, seed);
    std::string all;
    for (char number = 0; number < 100; ++number) {
      send(1, 1, number);
      all += number % 10 == 9 ? come(0) : "";  // a socket holds but a few
    }
    return all;
  }

  std::vector<TunEnd> ends_;
  std::vector<int> ours_;
};

TEST_F(RelayTest, CarriesBetweenTheFirstEndAndTheOthers) {
  const Relay relay(ends_, {}, 1);
  send(1, 1, 'a');
  send(0, 3, 'b');
  send(1, 3, 'c');
  send(0, 9, 'd');
  ASSERT_EQ(write(ours_[1], "no packet", 9), 9);
  EXPECT_EQ(come(0), "a");
  EXPECT_EQ(come(1), "");
  EXPECT_EQ(come(2), "b");
}

TEST_F(RelayTest, LosesTheSamePacketsForTheSameSeed) {
  const std::string once = a_hundred({.loss = 0.3}, 1);
  EXPECT_GT(once.size(), 50U);
  EXPECT_LT(once.size(), 90U);
  EXPECT_EQ(a_hundred({.loss = 0.3}, 1), once);
  EXPECT_NE(a_hundred({.loss = 0.3}, 2), once);
}

TEST_F(RelayTest, IsLate) {
  const Relay relay(ends_, {.delay_ms = 30.0}, 1);
  const auto start = Clock::now();
  send(0, 2, 'a');
  pollfd file{.fd = ours_[1], .events = POLLIN, .revents = 0};
  ASSERT_EQ(poll(&file, 1, 5000), 1);
  EXPECT_GE(Clock::now() - start, 30ms);
}

}  // namespace
}  // namespace evbal

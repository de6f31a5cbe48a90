#include "common/legs.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace evbal {
namespace {

using namespace std::chrono_literals;

TEST(Legs, CountAndAddUpByName) {
  Legs legs;
  EXPECT_TRUE(legs.taken().empty());
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(legs.time("b", [&] { return i; }), i);
  }
  legs.time("a", [] { std::this_thread::sleep_for(2ms); });
  EXPECT_THROW(legs.time("c", [] { throw std::runtime_error("no leg"); }), std::runtime_error);
  const std::vector<Leg> taken = legs.taken();
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_EQ(taken[0].name, "a");
  EXPECT_EQ(taken[0].times, 1);
  EXPECT_GE(taken[0].seconds, 0.002);
  EXPECT_EQ(taken[0].longest, taken[0].seconds);
  EXPECT_EQ(taken[1].name, "b");
  EXPECT_EQ(taken[1].times, 3);
  EXPECT_GE(taken[1].seconds, taken[1].longest);
}

TEST(Legs, MayBeAskedWhileTheyAreTimed) {
  Legs legs;
  std::thread timed([&] {
    for (int i = 0; i < 1000; ++i) {
      legs.time("a", [] {});
    }
  });
  for (int i = 0; i < 100; ++i) {
    legs.taken();
  }
  timed.join();
  EXPECT_EQ(legs.taken().front().times, 1000);
}

}  // namespace
}  // namespace evbal

#include "tools/gps/rides.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace evbal {
namespace {

/// Fixes a minute apart, 0.001 degrees (111 m) north of each other; '1' with passengers, '0' without, '-' none for 20
/// minutes.
std::vector<Fix> fixes(const std::string& flags) {
  std::vector<Fix> all;
  long long time = 0;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    time += flags[i] == '-' ? 1200 : 60;
    if (flags[i] != '-') {
      all.push_back({time, {37.7 + 0.001 * static_cast<double>(i), -122.4}, flags[i] == '1'});
    }
  }
  return all;
}

struct All {
  std::vector<Ride> rides;
  std::vector<VacantMove> moves;
  int cut_off = 0;
};

All find_all(const std::string& flags) {
  All all;
  RideFinder finder(15.0);
  for (const Fix& fix : fixes(flags)) {
    const auto found = finder.add(fix);
    if (found.ride) {
      all.rides.push_back(*found.ride);
    }
    if (found.vacant) {
      all.moves.push_back(*found.vacant);
    }
  }
  if (const auto last = finder.finish()) {
    all.moves.push_back(*last);
  }
  all.cut_off = finder.cut_off();
  return all;
}

TEST(RideFinder, FindsRidesBetweenFreeFixes) {
  const All all = find_all("0011100100");
  ASSERT_EQ(all.rides.size(), 2U);
  EXPECT_EQ(all.rides[0].pickup.time, 180);
  EXPECT_EQ(all.rides[0].dropoff.time, 360);
  EXPECT_EQ(all.rides[1].pickup.time, 480);
  EXPECT_EQ(all.rides[1].dropoff.time, 540);
  EXPECT_EQ(all.cut_off, 0);
}

TEST(RideFinder, LeavesOutRidesThatTheRecordsCutOff) {
  const All all = find_all("110011");
  EXPECT_TRUE(all.rides.empty());
  EXPECT_EQ(all.cut_off, 2);
}

TEST(RideFinder, FindsTheWaysBetweenRides) {
  const All all = find_all("0001000-00");
  ASSERT_EQ(all.moves.size(), 3U);
  EXPECT_EQ(all.moves[0].end, VacantMove::End::pickup);
  EXPECT_EQ(all.moves[0].to.time, 240);
  EXPECT_NEAR(all.moves[0].km, 0.334, 0.001);
  EXPECT_EQ(all.moves[1].end, VacantMove::End::gap);
  EXPECT_EQ(all.moves[1].from.time, 300);
  EXPECT_EQ(all.moves[1].to.time, 420);
  EXPECT_EQ(all.moves[2].end, VacantMove::End::records);
  EXPECT_NEAR(all.moves[2].km, 0.111, 0.001);
}

TEST(RideFinder, KeepsARideTogetherOverAGap) {
  const All all = find_all("01-10");
  ASSERT_EQ(all.rides.size(), 1U);
  EXPECT_EQ(all.rides[0].dropoff.time - all.rides[0].pickup.time, 1320);
}

}  // namespace
}  // namespace evbal

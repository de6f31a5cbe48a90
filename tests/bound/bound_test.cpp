#include "agents/world/draws.hpp"
#include "common/error.hpp"
#include "experiments/bound/bound_front.hpp"
#include "tests/support/worlds.hpp"
#include "tools/verify/cheapest_day.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace evbal {
namespace {

bool never(const BoundProgress&) {
  return false;
}

/// Only what is a bound.
bool but_up(const BoundProgress& progress) {
  return progress.rounding == Rounding::up;
}

/// Two regions, 10 km and 20 min apart; trips within one take 10 min.
BoundDay two_regions(const std::vector<int>& cars, const std::vector<BoundPassenger>& passengers) {
  BoundDay day;
  day.ticks = 12;
  day.tick = 5;
  day.step = 30;
  day.km = (Eigen::MatrixXd(2, 2) << 1, 10, 10, 1).finished();
  day.minutes = (Eigen::MatrixXi(2, 2) << 10, 20, 20, 10).finished();
  day.cars = cars;
  day.passengers = passengers;
  return day;
}

/// All that makes a passenger, to be sorted.
using Told = std::tuple<int, int, int, int>;

std::vector<Told> told(const BoundDay& day) {
  std::vector<Told> all;
  for (const BoundPassenger& one : day.passengers) {
    all.emplace_back(one.origin, one.appears, one.destination, one.last);
  }
  std::sort(all.begin(), all.end());
  return all;
}

RC_GTEST_PROP(BoundDay, HasThePassengersWhoCanBeLost, ()) {
  const World world = *test::small_worlds();
  std::vector<Told> drawn;
  for (int region = 0; region < world.city.size(); ++region) {
    for (const Passenger& one : draw_passengers(world, region)) {
      if (one.appears + one.patience < world.clock.minutes()) {
        drawn.emplace_back(region, one.appears, one.destination, one.appears + one.patience);
      }
    }
  }
  std::sort(drawn.begin(), drawn.end());
  const BoundDay day = bound_day(world, test::no_faults);
  RC_ASSERT(told(day) == drawn);
  const auto twice = [&](int tick) {
    Faults faults = test::no_faults(tick);
    for (int region = 0; region < world.city.size(); ++region) {
      faults.effects.push_back({.fault = 0, .type = EffectType::demand_scale, .region = region, .magnitude = 2.0});
    }
    return faults;
  };
  RC_ASSERT(told(bound_day(world, twice)).size() >= drawn.size());
  RC_ASSERT(std::accumulate(day.cars.begin(), day.cars.end(), 0) == world.city.fleet.vehicles);
}

TEST(CapacityBound, IsWorkedOutByHand) {
  // Six trips of 20 min that must begin within five minutes, for two cars, in a window of 30 min.
  std::vector<BoundPassenger> six(6, {.origin = 0, .destination = 1, .appears = 2, .last = 7});
  const CapacityBound bound = capacity_bound(two_regions({2, 0}, six));
  EXPECT_EQ(bound.lost, 3);  // 60 car-minutes for trips of 20
  EXPECT_EQ(bound.start, 0);
  EXPECT_EQ(bound.end, 30);
}

TEST(DayBound, OfOneTripIsTheWayToIt) {
  const BoundDay day = two_regions({1, 0}, {{.origin = 1, .destination = 0, .appears = 25, .last = 30}});
  const DayBound bound = day_bound(day, {4.0, 40.0}, never);
  ASSERT_EQ(bound.points.size(), 2U);
  EXPECT_NEAR(bound.points[0].bound, 4.0, 1e-4);  // cheaper to lose him
  EXPECT_NEAR(bound.points[1].bound, 10.0, 1e-3);
  EXPECT_NEAR(bound.points[1].up->km, 10.0, 1e-2);
  EXPECT_NEAR(fewest_lost(bound, 5.0), 0.125, 1e-4);  // 40 lost + 5 >= 10
  EXPECT_EQ(fewest_lost(bound, 11.0), 0.0);
}

TEST(DayBound, RoundsArrivalsDownAndUp) {
  // A car is there in minute 24 for a passenger who is gone after minute 21: down it is as if it came in 20.
  BoundDay day = two_regions({1, 0}, {{.origin = 1, .destination = 0, .appears = 20, .last = 21}});
  day.minutes(0, 1) = 24;
  const DayBound bound = day_bound(day, {40.0}, never);
  EXPECT_NEAR(bound.points[0].bound, 10.0, 1e-3);
  EXPECT_NEAR(bound.points[0].up->lost, 1.0, 1e-3);
  EXPECT_NEAR(*bound.points[0].bracket(), 3.0, 1e-2);
}

TEST(DayBound, IsOneWheneverItIsStopped) {
  const BoundDay day = tiny_day(3);
  const double best = day_bound(day, {5.0}, never).points.front().bound;
  for (int asked = 0; asked < 12; ++asked) {
    int left = asked;
    const DayBound stopped = day_bound(day, {5.0}, [&](const BoundProgress&) { return left-- <= 0; });
    EXPECT_LE(stopped.points.front().bound, best + 1e-4) << asked;
    EXPECT_GE(stopped.points.front().bound, 0.0) << asked;
    EXPECT_EQ(stopped.points.front().tight, stopped.points.front().down.has_value()) << asked;
  }
}

TEST(DayBound, RefusesWhatNoMemoryHolds) {
  BoundDay day = two_regions({1, 1}, {});
  day.ticks = 1000;
  day.cars.assign(2000, 1);
  try {
    day_bound(day, {1.0}, never);
    ADD_FAILURE() << "took it";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("2000 regions and ticks of 5 min takes "), std::string::npos);
  }
}

TEST(DayBound, KeepsTheBetterOfTwo) {
  DayBound one;
  one.points = {{.price = 2.0, .bound = 7.0, .tight = true, .up = Driving{}}, {.price = 5.0, .bound = 8.0}};
  DayBound other;
  other.points = {{.price = 1.0, .bound = 3.0}, {.price = 2.0, .bound = 4.0}, {.price = 5.0, .bound = 9.0}};
  const DayBound both = merged(one, other);
  ASSERT_EQ(both.points.size(), 3U);
  EXPECT_EQ(both.points[0].price, 1.0);
  EXPECT_EQ(both.points[1].bound, 7.0);
  EXPECT_EQ(both.points[2].bound, 9.0);
}

TEST(DayBound, HasTheCornersOfAllItsLines) {
  DayBound bound;
  bound.points = {{.price = 1.0, .bound = 10.0}, {.price = 4.0, .bound = 16.0}};
  const std::vector<Driving> corners = bound_corners(bound);
  ASSERT_EQ(corners.size(), 4U);
  EXPECT_DOUBLE_EQ(corners[0].lost, 10.0);  // at 0 km
  EXPECT_DOUBLE_EQ(corners[1].km, 8.0);     // where the lines cross
  EXPECT_DOUBLE_EQ(corners[1].lost, 2.0);
  EXPECT_DOUBLE_EQ(corners[3].km, 16.0);
  EXPECT_DOUBLE_EQ(corners[3].lost, 0.0);
}

TEST(DayBound, IsNotAboveTheBestOfAllPlays) {
  int equal = 0;
  int days = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const BoundDay day = tiny_day(seed);
    const double cheapest = cheapest_day(day, 7.0);
    const double bound = day_bound(day, {7.0}, but_up).points.front().bound;
    EXPECT_LE(bound, cheapest + 1e-9) << "seed " << seed;
    if (day.tick == 1) {
      ++days;
      equal += std::abs(bound - cheapest) < 1e-2 ? 1 : 0;
    }
  }
  // Nothing is rounded on these. In the others half a car serves half a passenger, or leaves when it arrives.
  EXPECT_GE(days, 15);
  EXPECT_GE(4 * equal, 3 * days);
}

// The capacity bound knows no places.
RC_GTEST_PROP(CapacityBound, LiesBelowTheFront, ()) {
  const World world = *test::small_worlds();
  const DayBound bound = day_bound(bound_day(world, test::no_faults), {1e4}, never);
  RC_ASSERT(bound.points.front().up.has_value());
  // At such a price km hardly count. Up, no trip is shorter than it is; but part of a passenger may be served.
  RC_ASSERT(bound.capacity.lost <= bound.points.front().up->lost + 1.0 + 1e-3);
}

}  // namespace
}  // namespace evbal

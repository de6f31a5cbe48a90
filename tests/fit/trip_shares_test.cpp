#include "tools/fit/trip_shares.hpp"

#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <map>

namespace evbal {
namespace {

City three_regions() {
  City city;
  city.day_start = 5 * 60;
  city.step_minutes = 30;
  city.regions.resize(3);
  return city;
}

double share(const TripPeriod& period, int from, int to) {
  for (const TripShare& pair : period.shares) {
    if (pair.origin == from && pair.destination == to) {
      return pair.share;
    }
  }
  return 0.0;
}

TEST(TripShares, AreThoseOfTheirPeriodDrawnTowardsTheDays) {
  DemandDay day;
  day.steps.resize(38);
  day.steps[0] = {{0, 1, 50}};
  day.steps[4] = {{0, 2, 147}, {1, 1, 3}};
  const auto periods = trip_shares(three_regions(), {day});
  ASSERT_EQ(periods.size(), 10U);
  EXPECT_EQ(periods[0].start, 5 * 60);
  EXPECT_EQ(periods[9].start, 23 * 60);
  // Of the day's 197 trips 50 go to 1, of 50 among them 12.69.
  EXPECT_DOUBLE_EQ(share(periods[0], 0, 1), 0.627) << "62.69 of 100";
  EXPECT_DOUBLE_EQ(share(periods[0], 0, 2), 0.373);
  EXPECT_DOUBLE_EQ(share(periods[1], 0, 1), 0.064) << "12.69 of 197: 64.42 thousandths";
  EXPECT_DOUBLE_EQ(share(periods[1], 0, 2), 0.936) << "935.58: the larger remainder";
  EXPECT_DOUBLE_EQ(share(periods[5], 0, 1), 0.254) << "no trips: the day's";
  EXPECT_DOUBLE_EQ(share(periods[0], 1, 1), 1.0);
  EXPECT_DOUBLE_EQ(share(periods[0], 2, 2), 1.0) << "no trips at all";
}

TEST(TripShares, SumToOneInAllRegions) {
  const City city = read_city(test::in_source("experiments/cities/toy-5"));
  std::vector<DemandDay> days;
  for (const auto& date : city.train_days) {
    days.push_back(read_demand(city, date));
  }
  for (const TripPeriod& period : trip_shares(city, days)) {
    std::map<int, double> sums;
    for (const TripShare& pair : period.shares) {
      EXPECT_GT(pair.share, 0.0);
      sums[pair.origin] += pair.share;
    }
    ASSERT_EQ(sums.size(), 5U);
    for (const auto& [region, sum] : sums) {
      EXPECT_NEAR(sum, 1.0, 1e-12) << region;
    }
  }
}

}  // namespace
}  // namespace evbal

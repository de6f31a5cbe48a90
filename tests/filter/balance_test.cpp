#include "coordinator/filter/balance.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

// Ten vacant cars, two low ones, one passenger who waits; four come, one goes, a session ends and one begins.
const RegionCounts before{10.0, 2.0, 1.0, 1.0};
const RegionWindow window{
    .came_vacant = 4.0, .left_vacant = 1.0, .ended = 1.0, .begun = 1.0, .dropped_off = 0.4, .low_share = 0.1};

TEST(Balance, LeavesNothingOverOfATrueReport) {
  // Five appear and nobody waits: six are picked up. One of those who came free is low.
  const Excess excess = excess_of(before, window, {7.0, 2.0, 1.0, 0.0}, 5.0);
  EXPECT_EQ(excess.cars, 0);
  EXPECT_EQ(excess.low, 1);
  EXPECT_NEAR(excess.expected, 0.4 + 0.1, 1e-12) << "drop-offs of short trips, and one in ten who gives up";
  EXPECT_NEAR(excess.expected_low, 0.54, 1e-12);
  EXPECT_EQ(excess.slack, 1);
}

TEST(Balance, IsLeftWithWhatAnyOfTheFourNumbersLies) {
  EXPECT_EQ(excess_of(before, window, {7.0 + 5.0, 2.0, 1.0, 0.0}, 5.0).cars, 5);
  const Excess low = excess_of(before, window, {7.0, 2.0 + 5.0, 1.0, 0.0}, 5.0);
  EXPECT_EQ(low.cars, 5);
  EXPECT_EQ(low.low, 1 + 5);
  EXPECT_EQ(excess_of(before, window, {7.0, 2.0, 1.0, 0.0 + 5.0}, 5.0).cars, -5);
  EXPECT_EQ(excess_of(before, window, {7.0, 2.0, 1.0, 0.0}, 5.0 + 5.0).cars, 5);
}

TEST(Balance, IsNotDisturbedByASpike) {
  // Five more appear: three are picked up by cars that were there, two wait.
  EXPECT_EQ(excess_of(before, window, {7.0 - 3.0, 2.0, 1.0, 0.0 + 2.0}, 5.0 + 5.0).cars, 0);
}

TEST(Balance, AsksTheForecastWhetherPassengersAreWrong) {
  const auto favours = [](int cars, double demand) {
    Excess excess;
    excess.cars = cars;
    excess.expected = 0.2;
    return favours_passengers(excess, cars - 0.2, demand, 3.0, 4.0);
  };
  EXPECT_EQ(favours(0, 3.0), 0.0);
  EXPECT_GT(favours(8, 11.0), 2.0) << "three really appeared, as usual";
  EXPECT_LT(favours(8, 3.0), -2.0) << "less than none cannot have appeared";
  EXPECT_LT(favours(-8, 3.0), -2.0) << "eleven are many";
  EXPECT_GT(favours(-4, 0.0), 0.5) << "four are more usual than none";
}

TEST(Balance, TakesWhatAddsUpForPassengersAndWhatComesBackForCars) {
  const auto favours = [](double off) {
    Excess excess;
    excess.cars = 6;
    return favours_passengers(excess, off, 9.0, 6.0, 9.0);
  };
  EXPECT_GT(favours(12.0), favours(6.0) + 0.5) << "the second excess of six";
  EXPECT_LT(favours(0.0), favours(6.0) - 1.0) << "cars were six too few before";
}

TEST(Balance, ConservesCarsInItsPrediction) {
  const StockChange change = stock_change(window, {6.0, 0.2});
  // Four came and 0.4 will have; one was sent off, six were picked up.
  EXPECT_NEAR(total(change.change), 4.4 - 1.0 - 6.0, 1e-12);
  // Who comes out low moves cars within the region only.
  EXPECT_NEAR(total_variance(change.noise), 0.2 + 0.4, 0.05);
}

}  // namespace
}  // namespace evbal

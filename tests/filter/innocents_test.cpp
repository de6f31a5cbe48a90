#include "coordinator/filter/innocents.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace evbal {
namespace {

using Regions = std::vector<int>;

/// -ln of how likely the city's surplus and the odds of a set are, but for a constant; `set` has a bit for each
/// suspect.
double cost(double surplus, double variance, const std::vector<Suspect>& suspects, unsigned set) {
  double price = 0.0;
  for (std::size_t k = 0; k < suspects.size(); ++k) {
    if ((set >> k & 1U) != 0) {
      surplus += suspects[k].more;
      variance -= suspects[k].variance;
      price += suspects[k].price;
    }
  }
  return price + surplus * surplus / (2.0 * (variance + 1.0)) + std::log(variance + 1.0) / 2.0;
}

TEST(Innocents, AreAllOfThemIfTheCityIsTheFleetWithAll) {
  EXPECT_EQ(likeliest_innocents(-1.0, 1.5, {{3, 5.0, 0.5, -1.0}, {7, -6.0, 0.5, -1.0}, {8, 2.0, 0.5, -1.0}}),
            (Regions{3, 7, 8}));
}

TEST(Innocents, AreNotThoseWithWhomTheCityHasTooManyCars) {
  EXPECT_EQ(likeliest_innocents(0.0, 1.0, {{3, 7.0, 0.5, -1.0}, {7, 6.0, 0.5, -1.0}}), Regions{});
}

TEST(Innocents, AreTheOneWhoseCarsTheCityLacks) {
  EXPECT_EQ(likeliest_innocents(-6.0, 1.0, {{3, 9.0, 0.5, 2.0}, {7, 6.0, 0.5, 2.0}}), Regions{7});
}

TEST(Innocents, AreNoneOnThinEvidence) {
  EXPECT_EQ(likeliest_innocents(-2.0, 30.0, {{3, 2.0, 15.0, 2.0}, {7, 1.0, 15.0, 2.0}}), Regions{});
}

TEST(Innocents, AreTheLikeliestOfAllSets) {
  std::mt19937 draw(7);
  std::normal_distribution<double> cars(0.0, 5.0);
  for (int round = 0; round < 200; ++round) {
    std::vector<Suspect> suspects;
    double variance = 0.3;
    for (int region = 0; region < 6; ++region) {
      suspects.push_back({region, std::round(cars(draw)), 0.3 + 0.2 * region, region % 2 == 0 ? -1.0 : 2.0});
      variance += suspects.back().variance;
    }
    const double surplus = cars(draw);
    unsigned found = 0;
    for (const int region : likeliest_innocents(surplus, variance, suspects)) {
      found |= 1U << static_cast<unsigned>(region);
    }
    double least = std::numeric_limits<double>::infinity();
    for (unsigned set = 0; set < 64; ++set) {
      least = std::min(least, cost(surplus, variance, suspects, set));
    }
    EXPECT_NEAR(cost(surplus, variance, suspects, found), least, 1e-9) << round;
  }
}

}  // namespace
}  // namespace evbal

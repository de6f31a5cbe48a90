#include "coordinator/balancing/discrete_distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace evbal {
namespace {

// E[max(0, r - s)]
double expected_shortage(const DiscreteDistribution& law, double s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < law.values.size(); ++i) {
    sum += law.probabilities[i] * std::max(0.0, law.values[i] - s);
  }
  return sum;
}

TEST(DiscreteDistribution, EqualValuesAreOne) {
  const auto law = empirical({3.0, 0.0, 3.0, 1.0});
  EXPECT_EQ(law.values, (std::vector<double>{0.0, 1.0, 3.0}));
  EXPECT_EQ(law.probabilities, (std::vector<double>{0.25, 0.25, 0.5}));
  EXPECT_EQ(mirrored(law).values, (std::vector<double>{-3.0, -1.0, 0.0}));
  EXPECT_EQ(mirrored(law).probabilities, (std::vector<double>{0.5, 0.25, 0.25}));
}

TEST(DiscreteDistribution, NegativeBinomialHasItsMoments) {
  for (const double mean : {0.01, 0.7, 5.0, 40.0, 2000.0}) {
    const double variance = 1.36 * mean + 0.014 * mean * mean;
    const auto law = negative_binomial(mean, variance);
    EXPECT_NEAR(std::accumulate(law.probabilities.begin(), law.probabilities.end(), 0.0), 1.0, 1e-12);
    EXPECT_NEAR(law.mean(), mean, 1e-6 * std::max(1.0, mean));
    EXPECT_TRUE(std::ranges::is_sorted(law.values));
    EXPECT_LE(law.values.size(), 65U);
    double second = 0.0;
    for (std::size_t i = 0; i < law.values.size(); ++i) {
      second += law.probabilities[i] * std::pow(law.values[i] - mean, 2);
    }
    EXPECT_LT(second, variance * 1.0001) << "joined values vary less";
    EXPECT_GT(second, variance * 0.8);
  }
  EXPECT_EQ(negative_binomial(0.0, 0.0).values, std::vector<double>{0.0});
}

// Against the textbook's probabilities, by the gamma function.
TEST(DiscreteDistribution, NegativeBinomialMissesLittleByJoining) {
  const double mean = 6.0;
  const double variance = 9.0;
  const double size = mean * mean / (variance - mean);
  const auto law = negative_binomial(mean, variance);
  for (const double s : {0.0, 1.0, 4.5, 6.0, 10.0, 15.0}) {
    double exact = 0.0;
    for (int r = 0; r < 200; ++r) {
      const double logarithm = std::lgamma(r + size) - std::lgamma(size) - std::lgamma(r + 1.0) +
                               size * std::log(mean / variance) + r * std::log(1.0 - mean / variance);
      exact += std::exp(logarithm) * std::max(0.0, r - s);
    }
    EXPECT_LE(expected_shortage(law, s), exact + 1e-8) << s;
    EXPECT_NEAR(expected_shortage(law, s), exact, 0.03) << s;
  }
}

TEST(DiscreteDistribution, NegativeBinomialWithoutOverdispersionIsPoisson) {
  const auto law = negative_binomial(2.0, 0.5);
  EXPECT_NEAR(law.probabilities[0], std::exp(-2.0), 1e-9);
  EXPECT_NEAR(law.probabilities[1], 2.0 * std::exp(-2.0), 1e-9);
}

TEST(DiscreteDistribution, CountsUpToTheWholeOfANegativeBinomial) {
  for (const double mean : {0.3, 4.0, 40.0}) {
    for (const double variance : {mean, 1.5 * mean}) {
      double expected = 0.0;
      for (double k = 0.0; k < 400.0; k += 1.0) {
        expected += 1.0 - negative_binomial_at_most(k, mean, variance);
      }
      EXPECT_NEAR(expected, mean, 1e-6 * mean);
      EXPECT_DOUBLE_EQ(negative_binomial_at_most(-1.0, mean, variance), 0.0);
    }
  }
}

}  // namespace
}  // namespace evbal

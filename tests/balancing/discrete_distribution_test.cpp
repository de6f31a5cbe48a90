#include "coordinator/balancing/discrete_distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace evbal {
namespace {

// E[max(0, r - s)]
double expected_shortage(const DiscreteDistribution& distribution, double s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < distribution.values.size(); ++i) {
    sum += distribution.probabilities[i] * std::max(0.0, distribution.values[i] - s);
  }
  return sum;
}

TEST(DiscreteDistribution, EqualValuesAreOne) {
  const auto distribution = empirical({3.0, 0.0, 3.0, 1.0});
  EXPECT_EQ(distribution.values, (std::vector<double>{0.0, 1.0, 3.0}));
  EXPECT_EQ(distribution.probabilities, (std::vector<double>{0.25, 0.25, 0.5}));
}

TEST(DiscreteDistribution, NegativeBinomialHasItsMoments) {
  for (const double mean : {0.01, 0.7, 5.0, 40.0, 2000.0}) {
    const double variance = 1.36 * mean + 0.014 * mean * mean;
    const auto distribution = negative_binomial(mean, variance);
    EXPECT_NEAR(std::accumulate(distribution.probabilities.begin(), distribution.probabilities.end(), 0.0), 1.0, 1e-12);
    EXPECT_NEAR(distribution.mean(), mean, 1e-6 * std::max(1.0, mean));
    EXPECT_TRUE(std::ranges::is_sorted(distribution.values));
    EXPECT_LE(distribution.values.size(), 65U);
    double second = 0.0;
    for (std::size_t i = 0; i < distribution.values.size(); ++i) {
      second += distribution.probabilities[i] * std::pow(distribution.values[i] - mean, 2);
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
  const auto distribution = negative_binomial(mean, variance);
  for (const double s : {0.0, 1.0, 4.5, 6.0, 10.0, 15.0}) {
    double exact = 0.0;
    for (int r = 0; r < 200; ++r) {
      const double logarithm = std::lgamma(r + size) - std::lgamma(size) - std::lgamma(r + 1.0) +
                               size * std::log(mean / variance) + r * std::log(1.0 - mean / variance);
      exact += std::exp(logarithm) * std::max(0.0, r - s);
    }
    EXPECT_LE(expected_shortage(distribution, s), exact + 1e-8) << s;
    EXPECT_NEAR(expected_shortage(distribution, s), exact, 0.03) << s;
  }
}

TEST(DiscreteDistribution, NegativeBinomialWithoutOverdispersionIsPoisson) {
  const auto distribution = negative_binomial(2.0, 0.5);
  EXPECT_NEAR(distribution.probabilities[0], std::exp(-2.0), 1e-9);
  EXPECT_NEAR(distribution.probabilities[1], 2.0 * std::exp(-2.0), 1e-9);
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

// The textbook's probability, by the gamma function.
double textbook_at_most(double count, double mean, double variance) {
  const double size = mean * mean / (variance - mean);
  double sum = 0.0;
  for (double k = 0.0; k <= count; k += 1.0) {
    sum += std::exp(std::lgamma(k + size) - std::lgamma(size) - std::lgamma(k + 1.0) +
                    size * std::log(mean / variance) + k * std::log1p(-mean / variance));
  }
  return sum;
}

TEST(DiscreteDistribution, CountsUpToTheWholeOfALargeMean) {
  for (const double mean : {50.0, 740.0, 760.0, 5000.0}) {
    const double variance = 1.5 * mean;
    for (const double off : {-2.0, 0.0, 1.0, 3.0}) {
      const double count = std::floor(mean + off * std::sqrt(variance));
      EXPECT_NEAR(negative_binomial_at_most(count, mean, variance), textbook_at_most(count, mean, variance), 1e-9)
          << count << " of " << mean;
    }
  }
  // Poisson: P(at most 800 of 800), P(at most 10000 of 10000), P(at most 9900 of 10000), summed in 60 digits.
  EXPECT_NEAR(negative_binomial_at_most(800.0, 800.0, 800.0), 0.509401657999942, 1e-9);
  EXPECT_NEAR(negative_binomial_at_most(10000.0, 10000.0, 10000.0), 0.502659581219008, 1e-9);
  EXPECT_NEAR(negative_binomial_at_most(9900.0, 10000.0, 10000.0), 0.159871182245284, 1e-9);
}

TEST(DiscreteDistribution, OfATinyMeanIsOfNumbers) {
  for (const double mean : {1e-12, 1e-170, 1e-300, 5e-324}) {
    const auto distribution = negative_binomial(mean, 1.4 * mean);
    for (std::size_t i = 0; i < distribution.values.size(); ++i) {
      EXPECT_TRUE(std::isfinite(distribution.values[i])) << mean;
      EXPECT_GT(distribution.probabilities[i], 0.0) << mean;
    }
  }
}

}  // namespace
}  // namespace evbal

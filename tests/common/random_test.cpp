#include "common/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace evbal {
namespace {

RandomStream stream(std::uint64_t index) {
  return {7, Purpose::passenger, {.region = 3, .tick = 5, .index = index}};
}

TEST(RandomStream, EqualKeysGiveEqualDraws) {
  auto a = stream(1);
  auto b = stream(1);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(a.bits(), b.bits());
  }
}

TEST(RandomStream, EveryPartOfTheKeyMatters) {
  const auto first = [](std::uint64_t seed, Purpose purpose, StreamKey key) {
    return RandomStream(seed, purpose, key).bits();
  };
  const auto reference = first(1, Purpose::passenger, {.region = 1, .tick = 1, .index = 1});
  EXPECT_NE(reference, first(2, Purpose::passenger, {.region = 1, .tick = 1, .index = 1}));
  EXPECT_NE(reference, first(1, Purpose::session, {.region = 1, .tick = 1, .index = 1}));
  EXPECT_NE(reference, first(1, Purpose::passenger, {.region = 2, .tick = 1, .index = 1}));
  EXPECT_NE(reference, first(1, Purpose::passenger, {.region = 1, .tick = 2, .index = 1}));
  EXPECT_NE(reference, first(1, Purpose::passenger, {.region = 1, .tick = 1, .index = 2}));
}

// Known answer: Philox4x64-10 of counter 0 and key 0, from the kat_vectors of Random123.
TEST(RandomStream, IsPhilox) {
  RandomStream zero(0, static_cast<Purpose>(0), {});
  EXPECT_EQ(zero.bits(), 0x16554d9eca36314cULL);
  EXPECT_EQ(zero.bits(), 0xdb20fe9d672d0fdcULL);
  EXPECT_EQ(zero.bits(), 0xd7e772cee186176bULL);
  EXPECT_EQ(zero.bits(), 0x7e68b68aec7ba23bULL);
}

template <class Draw>
std::pair<double, double> moments(Draw draw) {
  constexpr int count = 20000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < count; ++i) {
    auto source = stream(static_cast<std::uint64_t>(i));
    const double value = draw(source);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {mean, squares / count - mean * mean};
}

TEST(RandomStream, DistributionsHaveTheirMoments) {
  const auto [uniform_mean, uniform_variance] = moments([](RandomStream& s) { return s.uniform(); });
  EXPECT_NEAR(uniform_mean, 0.5, 0.01);
  EXPECT_NEAR(uniform_variance, 1.0 / 12.0, 0.003);
  const auto [normal_mean, normal_variance] = moments([](RandomStream& s) { return s.normal(); });
  EXPECT_NEAR(normal_mean, 0.0, 0.03);
  EXPECT_NEAR(normal_variance, 1.0, 0.04);
  const auto [exponential_mean, exponential_variance] = moments([](RandomStream& s) { return s.exponential(3.0); });
  EXPECT_NEAR(exponential_mean, 3.0, 0.1);
  EXPECT_NEAR(exponential_variance, 9.0, 0.8);
  for (const double mean : {0.3, 4.0, 700.0}) {
    const auto [m, v] = moments([=](RandomStream& s) { return static_cast<double>(s.poisson(mean)); });
    EXPECT_NEAR(m, mean, 0.05 * std::sqrt(mean));
    EXPECT_NEAR(v, mean, 0.05 * mean);
  }
}

TEST(RandomStream, WeightedDrawsNeverTakeAZeroWeight) {
  const std::vector<double> weights = {0.0, 1.0, 0.0, 3.0, 0.0};
  int last = 0;
  constexpr int count = 4000;
  for (int i = 0; i < count; ++i) {
    auto source = stream(static_cast<std::uint64_t>(i));
    const auto drawn = source.weighted(weights);
    ASSERT_TRUE(drawn == 1 || drawn == 3);
    last += drawn == 3 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(last) / count, 0.75, 0.03);
}

}  // namespace
}  // namespace evbal

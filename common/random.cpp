#include "common/random.hpp"

#include "common/contract.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace evbal {

RandomStream::RandomStream(std::uint64_t seed, Purpose purpose, StreamKey key)
    : key_{seed, static_cast<std::uint64_t>(purpose)}, counter_{0, key.region, key.tick, key.index} {}

std::uint64_t RandomStream::bits() {
  if (used_ == block_.size()) {
    const r123::Philox4x64 philox;
    const auto block = philox({{counter_[0], counter_[1], counter_[2], counter_[3]}}, {{key_[0], key_[1]}});
    for (unsigned i = 0; i < block_.size(); ++i) {
      block_[i] = block[i];
    }
    ++counter_[0];
    used_ = 0;
  }
  return block_[used_++];
}

double RandomStream::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

double RandomStream::uniform(double low, double high) {
  return low + (high - low) * uniform();
}

std::uint64_t RandomStream::below(std::uint64_t n) {
  EVBAL_EXPECT(n >= 1, "at least one value to draw from");
  const std::uint64_t rejected = (0 - n) % n;  // 2^64 mod n
  std::uint64_t draw = bits();
  while (draw < rejected) {
    draw = bits();
  }
  return draw % n;
}

double RandomStream::normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

double RandomStream::exponential(double mean) {
  return -mean * std::log(1.0 - uniform());
}

std::uint64_t RandomStream::poisson(double mean) {
  EVBAL_EXPECT(mean >= 0.0 && mean <= 1e6, "a mean within [0, 1e6]");
  // exp(-mean) underflows for large means: a sum of Poisson variables is Poisson.
  constexpr double block_mean = 256.0;
  std::uint64_t total = 0;
  while (mean > 0.0) {
    const double part = std::min(mean, block_mean);
    mean -= part;
    double term = std::exp(-part);
    double cumulative = term;
    const double u = uniform();
    std::uint64_t count = 0;
    while (u >= cumulative && term > 0.0) {
      ++count;
      term *= part / static_cast<double>(count);
      cumulative += term;
    }
    total += count;
  }
  return total;
}

std::size_t RandomStream::weighted(std::span<const double> weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  EVBAL_EXPECT(total > 0.0, "weights of which one is above zero");
  double rest = uniform() * total;
  std::size_t last = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0.0) {
      continue;
    }
    last = i;
    if (rest < weights[i]) {
      return i;
    }
    rest -= weights[i];
  }
  return last;
}

}  // namespace evbal

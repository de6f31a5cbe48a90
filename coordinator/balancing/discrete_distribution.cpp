#include "coordinator/balancing/discrete_distribution.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

namespace evbal {
namespace {

// Joins neighbours until each value has at least `least` of the probability; the topmost may have less.
DiscreteDistribution joined(const std::vector<double>& values, const std::vector<double>& probabilities, double least) {
  DiscreteDistribution distribution;
  double probability = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    probability += probabilities[i];
    moment += probabilities[i] * values[i];
    const bool last = i + 1 == values.size();
    if (probability >= least || (last && probability > 0.0)) {
      distribution.values.push_back(moment / probability);
      distribution.probabilities.push_back(probability);
      probability = moment = 0.0;
    }
  }
  return distribution;
}

// p(k + 1) / p(k) of a negative binomial.
double next_ratio(double k, double mean, double variance) {
  return (mean * mean + k * (variance - mean)) / (variance * (k + 1.0));
}

}  // namespace

double DiscreteDistribution::mean() const {
  return std::inner_product(values.begin(), values.end(), probabilities.begin(), 0.0);
}

DiscreteDistribution certain(double value) {
  return {{value}, {1.0}};
}

DiscreteDistribution empirical(std::vector<double> values) {
  EVBAL_EXPECT(!values.empty(), "at least one value");
  std::ranges::sort(values);
  DiscreteDistribution distribution;
  const double each = 1.0 / static_cast<double>(values.size());
  for (const double value : values) {
    if (!distribution.values.empty() && distribution.values.back() == value) {
      distribution.probabilities.back() += each;
    } else {
      distribution.values.push_back(value);
      distribution.probabilities.push_back(each);
    }
  }
  return distribution;
}

// From the mean outwards until the rest is negligible.
DiscreteDistribution negative_binomial(double mean, double variance, double least) {
  EVBAL_EXPECT(mean >= 0.0 && std::isfinite(mean) && std::isfinite(variance), "a finite mean of at least zero");
  if (mean == 0.0) {
    return certain(0.0);
  }
  constexpr double negligible = 1e-10;
  const double v = std::max(mean, variance);
  const auto ratio = [&](double k) { return next_ratio(k, mean, v); };
  const double middle = std::floor(mean);
  std::deque<double> weights{1.0};
  double lowest = middle;
  while (lowest > 0.0 && weights.front() > negligible) {
    lowest -= 1.0;
    weights.push_front(weights.front() / ratio(lowest));
  }
  for (double k = middle; weights.back() > negligible; k += 1.0) {
    weights.push_back(weights.back() * ratio(k));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<double> values;
  std::vector<double> probabilities;
  for (const double weight : weights) {
    values.push_back(lowest + static_cast<double>(values.size()));
    probabilities.push_back(weight / sum);
  }
  return joined(values, probabilities, least);
}

// Probabilities by their logarithms: that of no passengers underflows from a mean of 746 on.
double negative_binomial_at_most(double count, double mean, double variance) {
  EVBAL_EXPECT(mean > 0.0 && std::isfinite(mean) && std::isfinite(variance), "a finite mean above zero");
  EVBAL_EXPECT(count <= 1e9, "a count of at most 1e9");
  const double v = std::max(mean * (1.0 + 1e-9), variance);
  const double size = mean * mean / (v - mean);
  double logarithm = size * std::log1p((mean - v) / v);  // of the probability of none
  double sum = 0.0;
  for (int k = 0; k <= count; ++k) {
    sum += std::exp(logarithm);
    logarithm += std::log(next_ratio(k, mean, v));
  }
  return std::min(1.0, sum);
}

}  // namespace evbal

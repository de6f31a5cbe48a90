#pragma once

#include <vector>

namespace evbal {

/// A random number of finitely many values.
struct DiscreteDistribution {
  std::vector<double> values;         ///< ascending, at least one
  std::vector<double> probabilities;  ///< > 0, sum 1

  /// The expected value.
  double mean() const;
};

/// Surely this value.
DiscreteDistribution certain(double value);

/// `values` are equally likely; at least one.
DiscreteDistribution empirical(std::vector<double> values);

/// Negative binomial with this mean >= 0 and variance, Poisson where the variance is at most the mean. Neighbouring
/// values of less than `least` together are joined at their mean: fewer values, the same mean.
DiscreteDistribution negative_binomial(double mean, double variance, double least = 1.0 / 64.0);

/// Probability of at most `count` (up to 1e9) under the same negative binomial, without joining; mean > 0. Right to
/// 1e-9; takes as long as `count` is large.
double negative_binomial_at_most(double count, double mean, double variance);

}  // namespace evbal

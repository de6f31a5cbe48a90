#pragma once

namespace evbal {

/// How surprising a whole number is that should be a Poisson count of mean `expected`, with up to `slack` more that
/// nobody can foresee: -ln of the probability of a count that is at least as high, 0 up to `slack`. A count below zero
/// cannot be; it gets 6 for each one that it is below.
double surprise(int count, double expected, int slack);

/// ln of the probability of a whole number that should be such a count.
double log_probability(int count, double expected, int slack);

/// The whole numbers that a Poisson count of mean `expected` takes but for the 2.5 % lowest and the 2.5 % highest, and
/// the probability of these numbers, which is 95 % or more.
struct UsualCounts {
  int low = 0;               ///< the lowest
  int high = 0;              ///< the highest
  double probability = 0.0;  ///< of low to high
};
/// See UsualCounts; `expected` is above 0.
UsualCounts usual_counts(double expected);

}  // namespace evbal

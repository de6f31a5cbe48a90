#include "coordinator/filter/count_law.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

constexpr double surprise_below_zero = 6.0;
constexpr double least_mean = 0.02;  ///< of a count: no model of a city is so exact
constexpr double tail = 0.025;
constexpr double least_term = 1e-12;  ///< relative, of a sum that is cut off

double log_poisson(int count, double expected) {
  return count * std::log(expected) - expected - std::lgamma(count + 1.0);
}

double at_least(int count, double expected) {
  double term = std::exp(log_poisson(count, expected));
  double sum = 0.0;
  for (int next = count + 1; term > least_term * sum; ++next) {
    sum += term;
    term *= expected / next;
  }
  return sum;
}

}  // namespace

double surprise(int count, double expected, int slack) {
  if (count < 0) {
    return -surprise_below_zero * count;
  }
  return count <= slack ? 0.0 : -std::log(at_least(count - slack, std::max(expected, least_mean)));
}

double log_probability(int count, double expected, int slack) {
  if (count < 0) {
    return surprise_below_zero * count;
  }
  const double each = -std::log(slack + 1.0);  // those up to slack are alike
  return each + log_poisson(std::max(0, count - slack), std::max(expected, least_mean));
}

UsualCounts usual_counts(double expected) {
  UsualCounts usual;
  double term = std::exp(-expected);
  double below = 0.0;
  for (; below + term <= tail; term *= expected / ++usual.low) {
    below += term;
  }
  usual.high = usual.low;
  usual.probability = term;
  while (below + usual.probability < 1.0 - tail) {
    term *= expected / ++usual.high;
    usual.probability += term;
  }
  return usual;
}

}  // namespace evbal

#include "experiments/study/statistics/fault_influence.hpp"

#include "common/random.hpp"
#include "experiments/study/statistics/ranks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace evbal {
namespace {

constexpr int fewest_draws = 10;
constexpr int random_orders = 9999;

Interval with_interval(double correlation, int draws) {
  if (draws < fewest_draws || std::abs(correlation) > 1.0 - 1e-12) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {correlation, -infinity, infinity};
  }
  const double half = 1.959964 * std::sqrt((1.0 + correlation * correlation / 2.0) / (draws - 3.0));
  return {correlation, std::tanh(std::atanh(correlation) - half), std::tanh(std::atanh(correlation) + half)};
}

/// How large the correlation of ranks is, but for a factor that their order does not change.
double size_of(const std::vector<double>& a, const std::vector<double>& b) {
  return std::abs(std::inner_product(a.begin(), a.end(), b.begin(), 0.0));
}

/// The order as drawn counts as one of the random ones, so that the share is never 0.
double permutation_p(const std::vector<double>& x, std::vector<double> y) {
  RandomStream random(0, Purpose::resampled_day, {});
  const double drawn = size_of(x, y);
  int as_large = 1;
  for (int i = 0; i < random_orders; ++i) {
    for (std::size_t left = y.size(); left > 1; --left) {
      std::swap(y[left - 1], y[random.below(left)]);
    }
    as_large += size_of(x, y) >= drawn ? 1 : 0;
  }
  return static_cast<double>(as_large) / (random_orders + 1);
}

Influence influence_of(const DrawnQuantity& quantity, const std::vector<double>& metric) {
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < metric.size(); ++i) {
    if (!std::isnan(quantity.values[i])) {
      x.push_back(quantity.values[i]);
      y.push_back(metric[i]);
    }
  }
  const auto draws = static_cast<int>(x.size());
  const double correlation = rank_correlation(x, y);
  return {quantity.fault, quantity.quantity, draws, with_interval(correlation, draws),
          permutation_p(centred_ranks(x), centred_ranks(y))};
}

}  // namespace

std::vector<Influence> influences(const std::vector<DrawnQuantity>& quantities, const std::vector<double>& metric) {
  std::vector<Influence> all;
  std::vector<double> p;
  for (const auto& quantity : quantities) {
    all.push_back(influence_of(quantity, metric));
    p.push_back(all.back().p);
  }
  const std::vector<double> adjusted = holm(p);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].p_adjusted = adjusted[i];
  }
  std::stable_sort(all.begin(), all.end(), [](const Influence& a, const Influence& b) {
    return std::abs(a.correlation.mean) > std::abs(b.correlation.mean);
  });
  return all;
}

}  // namespace evbal

#include "coordinator/filter/innocents.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace evbal {
namespace {

constexpr double unknown_of_city = 1.0;  ///< variance of the surplus if all are believed: small lies are never found
constexpr double least_gain = 1e-9;

/// What the suspects that are believed come to.
struct Sums {
  double surplus = 0.0;
  double variance = 0.0;
  double price = 0.0;

  Sums with(const Suspect& suspect, double sign) const {
    return {surplus + sign * suspect.more, variance - sign * suspect.variance, price + sign * suspect.price};
  }

  double cost() const {
    const double spread = std::max(0.0, variance) + unknown_of_city;
    return price + 0.5 * (surplus * surplus / spread + std::log(spread));
  }
};

/// Who is believed.
struct Hypothesis {
  std::vector<bool> believed;
  Sums sums;

  /// With another opinion of one of them.
  Sums changed(const std::vector<Suspect>& suspects, const Sums& from, std::size_t k) const {
    return from.with(suspects[k], believed[k] ? -1.0 : 1.0);
  }
};

/// Changes one or two suspects for as long as that makes it likelier.
Hypothesis improved(Hypothesis is, const std::vector<Suspect>& suspects) {
  for (bool better = true; better;) {
    better = false;
    Sums best = is.sums;
    std::size_t first = 0;
    std::size_t second = 0;
    const auto consider = [&](const Sums& sums, std::size_t k, std::size_t j) {
      if (sums.cost() < best.cost() - least_gain) {
        best = sums;
        first = k;
        second = j;
        better = true;
      }
    };
    for (std::size_t k = 0; k < suspects.size(); ++k) {
      const Sums one = is.changed(suspects, is.sums, k);
      consider(one, k, k);
      for (std::size_t j = k + 1; j < suspects.size(); ++j) {
        consider(is.changed(suspects, one, j), k, j);
      }
    }
    if (better) {
      is.sums = best;
      is.believed[first].flip();
      if (second != first) {
        is.believed[second].flip();
      }
    }
  }
  return is;
}

}  // namespace

std::vector<int> likeliest_innocents(double surplus, double variance, const std::vector<Suspect>& suspects) {
  Hypothesis none{std::vector<bool>(suspects.size(), false), {surplus, variance, 0.0}};
  Hypothesis all{std::vector<bool>(suspects.size(), true), none.sums};
  for (const Suspect& suspect : suspects) {
    all.sums = all.sums.with(suspect, 1.0);
  }
  const Hypothesis few = improved(std::move(none), suspects);
  const Hypothesis many = improved(std::move(all), suspects);
  const Hypothesis& likeliest = many.sums.cost() < few.sums.cost() - least_gain ? many : few;
  std::vector<int> innocents;
  for (std::size_t k = 0; k < suspects.size(); ++k) {
    if (likeliest.believed[k]) {
      innocents.push_back(suspects[k].region);
    }
  }
  return innocents;
}

}  // namespace evbal

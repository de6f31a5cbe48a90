#include "experiments/metrics/fairness.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace evbal {
namespace {

/// Drop-offs count as supply to this extent: a car that drops a passenger off during the window serves again there,
/// but only for what is left of it (docs/model.md, section 4).
constexpr double phi = 0.6;

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double ratio_spread(std::span<const double> above, std::span<const double> below) {
  const double city = sum(above) / std::max(sum(below), 1.0);
  double total = 0.0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    total += std::abs(above[i] / std::max(below[i], 1.0) - city);
  }
  return total;
}

double share_spread(std::span<const double> above, std::span<const double> below) {
  const auto share = [](double value, double of) { return of > 0.0 ? value / of : 0.0; };
  const double all_above = sum(above);
  const double all_below = sum(below);
  double total = 0.0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    total += std::abs(share(above[i], all_above) - share(below[i], all_below));
  }
  return total;
}

}  // namespace

Unfairness& Unfairness::operator+=(const Unfairness& other) {
  demand += other.demand;
  demand_shares += other.demand_shares;
  demand_drop_offs += other.demand_drop_offs;
  charging += other.charging;
  charging_shares += other.charging_shares;
  return *this;
}

Unfairness Unfairness::operator/(double divisor) const {
  return {demand / divisor, demand_shares / divisor, demand_drop_offs / divisor, charging / divisor,
          charging_shares / divisor};
}

Unfairness unfairness(const Outcome& outcome) {
  std::vector<double> supply_and_drop_offs;
  std::vector<double> completions;
  std::vector<double> low_battery;
  for (std::size_t i = 0; i < outcome.supply.size(); ++i) {
    supply_and_drop_offs.push_back(outcome.supply[i] + phi * outcome.drop_offs[i]);
    if (outcome.points[i] > 0) {
      completions.push_back(outcome.completions[i]);
      low_battery.push_back(outcome.low_battery[i]);
    }
  }
  return {.demand = ratio_spread(outcome.demand, outcome.supply),
          .demand_shares = share_spread(outcome.demand, outcome.supply),
          .demand_drop_offs = ratio_spread(outcome.demand, supply_and_drop_offs),
          .charging = ratio_spread(completions, low_battery),
          .charging_shares = share_spread(completions, low_battery)};
}

}  // namespace evbal

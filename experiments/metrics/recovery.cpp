#include "experiments/metrics/recovery.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace evbal {
namespace {

/// Share of the greatest value without faults by which a curve may be off and still counts as back. Less would say
/// little: two days that differ in two passengers of the morning are as far apart as a fifth of it in the evening.
constexpr double band_share = 0.25;

/// How long it must stay so. Hours later the days are apart for other reasons than the fault.
constexpr int settled_minutes = 120;

double total(std::span<const double> values, bool stock) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return stock && !values.empty() ? sum / static_cast<double>(values.size()) : sum;
}

double greatest(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [](double most, double value) { return std::max(most, std::abs(value)); });
}

/// Minute at which the next fault after `end` begins, that of the day's end if there is none.
int next_start(std::span<const FaultWindow> faults, int end, int day_end) {
  int next = day_end;
  for (const auto& fault : faults) {
    next = fault.start >= end ? std::min(next, fault.start) : next;
  }
  return next;
}

/// Minutes from `end` until the curves are within the band and stay there, as far as `until` lets one see.
std::optional<int> minutes_until_back(const PairedCurves& curves, double band, int end, int until) {
  const int last = until / curves.step_minutes;
  int within = 0;  // steps in a row
  for (int step = end / curves.step_minutes; step < last; ++step) {
    const auto at = static_cast<std::size_t>(step);
    within = std::abs(curves.with[at] - curves.without[at]) <= band ? within + 1 : 0;
    if (within * curves.step_minutes >= settled_minutes || (within > 0 && step + 1 == last)) {
      return std::max(0, (step + 1 - within) * curves.step_minutes - end);
    }
  }
  return std::nullopt;
}

}  // namespace

const std::vector<CostedMetric>& costed_metrics() {
  static const std::vector<CostedMetric> all = {
      {"served"},        {"lost"},    {"wait_minutes"},      {"waiting", true},
      {"queue_minutes"}, {"idle_km"}, {"unfairness_demand"}, {"unfairness_charging"}};
  return all;
}

FaultCost fault_cost(const PairedCurves& curves, bool stock, std::span<const FaultWindow> faults) {
  EVBAL_EXPECT(curves.with.size() == curves.without.size(), "curves of one length");
  FaultCost cost{.with = total(curves.with, stock), .without = total(curves.without, stock)};
  const double hours = curves.step_minutes / 60.0;
  for (std::size_t step = 0; step < curves.with.size(); ++step) {
    const double difference = curves.with[step] - curves.without[step];
    cost.area += std::abs(difference) * hours;
    cost.signed_area += difference * hours;
  }
  cost.band = band_share * greatest(curves.without);
  const int day_end = static_cast<int>(curves.with.size()) * curves.step_minutes;
  int last_end = 0;
  for (const auto& fault : faults) {
    cost.by_fault.push_back(minutes_until_back(curves, cost.band, fault.end, next_start(faults, fault.end, day_end)));
    last_end = std::max(last_end, fault.end);
  }
  cost.recovered = minutes_until_back(curves, cost.band, last_end, day_end);
  return cost;
}

}  // namespace evbal

#include "experiments/study/statistics/front_gap.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <set>

namespace evbal {
namespace {

/// So that a day without any lost passengers has a logarithm too.
constexpr double half = 0.5;

/// The mean of ln(x) from `a` to `b`, both positive: (b ln b - a ln a) / (b - a) - 1.
double mean_log(double a, double b) {
  const double middle = (a + b) / 2.0;
  const double lean = (b - a) / (2.0 * middle);
  if (std::abs(lean) < 1e-4) {
    return std::log(middle) - lean * lean / 6.0;  // the next term is below 1e-17
  }
  return (b * std::log(b) - a * std::log(a)) / (b - a) - 1.0;
}

/// The corners of the fronts within [from, to], and these.
std::vector<double> corners_of(std::initializer_list<const std::vector<FrontPoint>*> fronts, double from, double to) {
  std::set<double> corners{from, to};
  for (const auto* points : fronts) {
    for (const FrontPoint& point : *points) {
      if (from < point.cost && point.cost < to) {
        corners.insert(point.cost);
      }
    }
  }
  return {corners.begin(), corners.end()};
}

double mean_between(const std::vector<FrontPoint>& front, const std::vector<double>& corners) {
  if (corners.size() == 1) {
    return *value_at(front, corners.front());
  }
  double area = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    area += (corners[i] - corners[i - 1]) * (*value_at(front, corners[i - 1]) + *value_at(front, corners[i])) / 2.0;
  }
  return area / (corners.back() - corners.front());
}

}  // namespace

std::optional<FrontGap> front_gap(const std::vector<FrontPoint>& front, const std::vector<FrontPoint>& reference,
                                  bool frozen) {
  if (front.empty() || reference.empty()) {
    return std::nullopt;
  }
  FrontGap gap;
  gap.from = std::max(front.front().cost, reference.front().cost);
  gap.to = std::min(front.back().cost, reference.back().cost);
  if (gap.from > gap.to || (gap.from == gap.to && !frozen)) {
    return std::nullopt;
  }
  const auto corners = corners_of({&front, &reference}, gap.from, gap.to);
  gap.value = mean_between(front, corners);
  gap.reference = mean_between(reference, corners);
  const double range = reference.back().cost - reference.front().cost;
  gap.covered = range > 0.0 ? (gap.to - gap.from) / range : 1.0;
  return gap;
}

double mean_log_ratio(const std::vector<FrontPoint>& front, const std::vector<FrontPoint>& reference,
                      const FrontGap& gap) {
  EVBAL_EXPECT(gap.value >= 0.0 && gap.reference >= 0.0, "values that are not negative");
  if (gap.from == gap.to) {
    return std::log((gap.value + half) / (gap.reference + half));
  }
  const auto corners = corners_of({&front, &reference}, gap.from, gap.to);
  double sum = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const auto log_of = [&](const std::vector<FrontPoint>& points) {
      return mean_log(*value_at(points, corners[i - 1]) + half, *value_at(points, corners[i]) + half);
    };
    sum += (corners[i] - corners[i - 1]) * (log_of(front) - log_of(reference));
  }
  return sum / (gap.to - gap.from);
}

double mean_value(const std::vector<FrontPoint>& front, double from, double to) {
  return mean_between(front, corners_of({&front}, from, to));
}

}  // namespace evbal

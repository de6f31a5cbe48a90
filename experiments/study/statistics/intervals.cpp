#include "experiments/study/statistics/intervals.hpp"

#include "common/contract.hpp"

#include <unsupported/Eigen/SpecialFunctions>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace evbal {
namespace {

constexpr double level = 0.95;

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> day_means(const std::vector<DayValue>& values) {
  EVBAL_EXPECT(!values.empty(), "at least one value");
  std::map<std::string, std::vector<double>> by_day;
  for (const auto& [day, value] : values) {
    by_day[day].push_back(value);
  }
  std::vector<double> means;
  means.reserve(by_day.size());
  for (const auto& [day, of_day] : by_day) {
    means.push_back(mean(of_day));
  }
  return means;
}

/// P(|T| > t) = I_x(degrees / 2, 1 / 2) with x = degrees / (degrees + t^2).
double outside(double t, int degrees) {
  return Eigen::numext::betainc(degrees / 2.0, 0.5, degrees / (degrees + t * t));
}

/// Standard error of a mean of two values or more; nothing where these are one value but for rounding, other than 0.
std::optional<double> standard_error(const std::vector<double>& values, double centre) {
  if (values.size() < 2) {
    return std::nullopt;
  }
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - centre) * (value - centre);
  }
  const auto count = static_cast<double>(values.size());
  const double error = std::sqrt(squares / (count - 1.0) / count);
  const double rounding = 10.0 * std::numeric_limits<double>::epsilon() * std::abs(centre);
  return error > rounding || centre == 0.0 ? std::optional(error) : std::nullopt;
}

Interval unknown(double mean) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {mean, -infinity, infinity};
}

}  // namespace

double student_t(double probability, int degrees) {
  EVBAL_EXPECT(probability > 0.0 && probability < 1.0 && degrees >= 1,
               "a probability within (0, 1) and at least one degree of freedom");
  double low = 0.0;
  double high = 1.0;
  while (outside(high, degrees) > 1.0 - probability) {
    high *= 2.0;
  }
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2.0;
    (outside(middle, degrees) > 1.0 - probability ? low : high) = middle;
  }
  return high;
}

bool is_known(const Interval& interval) {
  return std::isfinite(interval.low) && std::isfinite(interval.high);
}

Interval t_interval(const std::vector<DayValue>& values) {
  const std::vector<double> means = day_means(values);
  const double centre = mean(means);
  const auto error = standard_error(means, centre);
  if (!error) {
    return unknown(centre);
  }
  const double half = student_t(level, static_cast<int>(means.size()) - 1) * *error;
  return {centre, centre - half, centre + half};
}

double t_test(const std::vector<DayValue>& values) {
  const std::vector<double> means = day_means(values);
  const double centre = mean(means);
  const auto error = standard_error(means, centre);
  return !error || centre == 0.0 ? 1.0 : outside(centre / *error, static_cast<int>(means.size()) - 1);
}

std::vector<double> holm(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, std::min(1.0, static_cast<double>(p.size() - i) * p[order[i]]));
    adjusted[order[i]] = largest;
  }
  return adjusted;
}

}  // namespace evbal

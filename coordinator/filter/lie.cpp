#include "coordinator/filter/lie.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evbal {
namespace {

constexpr double usual_variance = 1.0;  ///< of the difference between a count and its estimate
constexpr double of_the_truth = 1.0;    ///< difference from its estimate that a true count may have, beside deviations
constexpr double deviations = 2.0;

/// Of normal errors with this sum of squares, whose variance is known or, of noise, is what they show; less is better.
double criterion(SensorFaultKind kind, double squares, std::size_t n, int parameters) {
  const auto count = static_cast<double>(n);
  const double shown = squares / count;
  const double variance = kind == SensorFaultKind::noisy ? std::max(shown, usual_variance) : usual_variance;
  return count * (shown / variance + std::log(variance)) + parameters * std::log(count);
}

template <class Expected>
double squares_around(const std::vector<Saying>& sayings, const Expected& expected) {
  double sum = 0.0;
  for (std::size_t k = 0; k < sayings.size(); ++k) {
    const double error = sayings[k].reported - expected(k);
    sum += error * error;
  }
  return sum;
}

/// The best of all delays that the estimates before allow.
double squares_if_late(const std::vector<Saying>& sayings, const std::deque<double>& before) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t late = 1; late <= before.size(); ++late) {
    best = std::min(best, squares_around(sayings, [&](std::size_t k) {
                      return k < late ? before[before.size() - late + k] : sayings[k - late].estimate;
                    }));
  }
  return best;
}

}  // namespace

SensorFaultKind kind_of_lie(const std::vector<Saying>& sayings, const std::deque<double>& before) {
  if (sayings.back().reported < 0) {
    return SensorFaultKind::silent;
  }
  std::vector<Saying> said;
  std::ranges::copy_if(sayings, std::back_inserter(said), [](const Saying& saying) { return saying.reported >= 0; });
  double mean = 0.0;
  double off = 0.0;
  for (const Saying& saying : said) {
    mean += saying.reported / static_cast<double>(said.size());
    off += (saying.reported - saying.estimate) / static_cast<double>(said.size());
  }
  struct Explanation {
    SensorFaultKind kind;
    double squares;
    int parameters;
  };
  // One number alone is most simply off by something.
  const Explanation explanations[] = {
      {SensorFaultKind::biased, squares_around(said, [&](std::size_t k) { return said[k].estimate + off; }), 1},
      {SensorFaultKind::stuck, squares_around(said, [&](std::size_t /*k*/) { return std::round(mean); }), 1},
      {SensorFaultKind::delayed, squares_if_late(said, before), 2},
      {SensorFaultKind::noisy, squares_around(said, [&](std::size_t k) { return said[k].estimate; }), 1}};
  return std::ranges::min_element(
             explanations, {},
             [&](const Explanation& is) { return criterion(is.kind, is.squares, said.size(), is.parameters); })
      ->kind;
}

void Lie::hear(int reported, double estimate, double deviation) {
  sayings_.push_back({reported, estimate});
  const double allowed = deviation > 0.0 ? of_the_truth + deviations * deviation : 0.0;
  const bool agrees = reported >= 0 && std::abs(reported - estimate) <= allowed;
  true_in_a_row_ = agrees ? true_in_a_row_ + 1 : 0;
}

}  // namespace evbal

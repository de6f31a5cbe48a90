#pragma once

#include "agents/protocol/messages.hpp"

#include <deque>
#include <optional>
#include <vector>

namespace evbal {

/// What a field said while it was not believed, and what was taken to be true.
struct Saying {
  int reported = 0;       ///< by the field
  double estimate = 0.0;  ///< instead
};

/// What kind of lie explains the sayings best, by the Bayesian information criterion of normal errors: always the same
/// number (stuck), the estimate and a constant (biased), the estimate of some reports ago (delayed), or the estimate
/// and noise. `before` are the estimates before the first saying, the latest last. Numbers below zero are `silent`.
SensorFaultKind kind_of_lie(const std::vector<Saying>& sayings, const std::deque<double>& before);

/// A field of a region that is not believed.
class Lie {
 public:
  /// `before` are estimates of the field up to now, the latest last.
  explicit Lie(std::deque<double> before) : before_(std::move(before)) {}

  /// Notes what the field says, and what is taken to be true with this standard deviation.
  void hear(int reported, double estimate, double deviation);

  /// Whether the field has told the truth so often in a row that it can be believed again.
  bool over() const { return true_in_a_row_ >= reports_to_believe; }

  /// What explains it best so far.
  SensorFaultKind kind() const { return kind_of_lie(sayings_, before_); }

  /// What it said last, and what was taken to be true.
  const Saying& last() const { return sayings_.back(); }

 private:
  static constexpr int reports_to_believe = 3;

  std::deque<double> before_;
  std::vector<Saying> sayings_;
  int true_in_a_row_ = 0;
};

}  // namespace evbal

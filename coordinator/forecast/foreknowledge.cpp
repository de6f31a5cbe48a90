#include "coordinator/forecast/foreknowledge.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <utility>

namespace evbal {

Foreknowledge::Foreknowledge(Eigen::MatrixXd counts, int tick, int step)
    : counts_(std::move(counts)), tick_(tick), step_(step) {
  EVBAL_EXPECT(tick > 0 && step % tick == 0, "a step of whole ticks");
}

void Foreknowledge::observe(int /*minute*/, const Eigen::VectorXd& /*counts*/) {}

Eigen::MatrixXd Foreknowledge::forecast(int minute, int tau) const {
  Eigen::MatrixXd sums(counts_.rows(), tau);
  for (int k = 0; k < tau; ++k) {
    const auto ticks = static_cast<int>(counts_.cols());
    const int first = std::min((minute + k * step_) / tick_, ticks);
    const int last = std::min(first + step_ / tick_, ticks);
    sums.col(k) = counts_.middleCols(first, last - first).rowwise().sum();
  }
  return sums;
}

Eigen::MatrixXd Foreknowledge::scale(int /*minute*/, int tau) const {
  return Eigen::MatrixXd::Zero(counts_.rows(), tau);
}

NormalisedInnovation Foreknowledge::normalised_innovation(int /*minute*/) const {
  return {0.0, Eigen::VectorXd::Zero(counts_.rows())};
}

}  // namespace evbal

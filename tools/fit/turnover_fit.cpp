#include "tools/fit/turnover_fit.hpp"

#include "coordinator/balancing/discrete_distribution.hpp"

#include <algorithm>

namespace evbal {
namespace {

constexpr int bins = 10;

/// Spreads one count over the bins between its probability of less and of at most.
void add(Eigen::Ref<Eigen::VectorXd> shares, double below, double at_most) {
  const double width = std::max(1e-12, at_most - below);
  double before = 0.0;
  for (int bin = 0; bin < bins; ++bin) {
    const double edge = static_cast<double>(bin + 1) / bins;
    const double until = std::clamp((edge - below) / width, 0.0, 1.0);
    shares(bin) += until - before;
    before = until;
  }
}

}  // namespace

Eigen::MatrixXd same_step_dropoffs(const City& city, const std::vector<DemandDay>& days, int step) {
  Eigen::MatrixXd trips = Eigen::MatrixXd::Zero(city.size(), city.size());
  for (const DemandDay& day : days) {
    for (const auto& pairs : day.steps) {
      for (const TripCount& pair : pairs) {
        trips(pair.origin, pair.destination) += pair.trips;
      }
    }
  }
  const Eigen::VectorXd started = trips.rowwise().sum().cwiseMax(1.0);
  const Eigen::MatrixXd in_time = (1.0 - city.minutes.array() / step).max(0.0);
  return started.cwiseInverse().asDiagonal() * trips.cwiseProduct(in_time);
}

Eigen::MatrixXd integral_transform(const std::vector<HeldOutDay>& days, const CountVariance& variance, int leads) {
  Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(bins, leads);
  for (const HeldOutDay& day : days) {
    const Eigen::Index n = day.forecasts.rows() / leads;
    for (Eigen::Index row = 0; row < day.forecasts.rows(); ++row) {
      const Eigen::Index lead = row / n;
      for (Eigen::Index origin = 0; origin < day.forecasts.cols(); ++origin) {
        const double mean = day.forecasts(row, origin);
        const double count = day.counts(row, origin);
        if (mean > 0.0) {
          const double v = variance.at(lead, mean);
          add(shares.col(lead), negative_binomial_at_most(count - 1.0, mean, v),
              negative_binomial_at_most(count, mean, v));
        }
      }
    }
  }
  return shares * shares.colwise().sum().cwiseMax(1.0).cwiseInverse().asDiagonal();
}

}  // namespace evbal

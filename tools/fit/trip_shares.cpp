#include "tools/fit/trip_shares.hpp"

#include "common/eigen.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace evbal {
namespace {

constexpr int period_minutes = 120;
constexpr double prior_trips = 50.0;
constexpr double units = 1000.0;  ///< of which a share is a whole number

/// Trips by period, each N x N: from, to.
std::vector<Eigen::MatrixXd> count_trips(const City& city, const std::vector<DemandDay>& days) {
  const int periods = (24 * 60 - city.day_start + period_minutes - 1) / period_minutes;
  std::vector<Eigen::MatrixXd> counts(static_cast<std::size_t>(periods),
                                      Eigen::MatrixXd::Zero(city.size(), city.size()));
  for (const DemandDay& day : days) {
    for (std::size_t step = 0; step < day.steps.size(); ++step) {
      Eigen::MatrixXd& period = counts[step * static_cast<std::size_t>(city.step_minutes) / period_minutes];
      for (const TripCount& pair : day.steps[step]) {
        period(pair.origin, pair.destination) += pair.trips;
      }
    }
  }
  return counts;
}

/// What the shares of one origin's trips are proportional to; whole numbers, so that rounding is the same everywhere.
Eigen::VectorXd weights_of(const Eigen::VectorXd& period, const Eigen::VectorXd& day, Eigen::Index origin) {
  if (day.sum() == 0.0) {
    return Eigen::VectorXd::Unit(day.size(), origin);
  }
  return day.sum() * period + prior_trips * day;
}

/// Whole units in proportion to the weights that sum to `units`: rounded down, and what is missing goes to the largest
/// remainders.
Eigen::VectorXd whole_units(const Eigen::VectorXd& weights) {
  Eigen::VectorXd whole = (units * weights / weights.sum()).array().floor();
  const Eigen::VectorXd remainders = units * weights - weights.sum() * whole;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(weights.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](Eigen::Index i) { return remainders(i); });
  const auto missing = static_cast<std::size_t>(std::lround(units - whole.sum()));
  for (std::size_t rank = 0; rank < missing; ++rank) {
    whole(order[rank]) += 1.0;
  }
  return whole;
}

std::vector<TripShare> shares_of(const Eigen::MatrixXd& period, const Eigen::MatrixXd& day) {
  std::vector<TripShare> shares;
  for (int from = 0; from < day.rows(); ++from) {
    const Eigen::VectorXd whole = whole_units(weights_of(period.row(from), day.row(from), from));
    for (int to = 0; to < day.cols(); ++to) {
      if (whole(to) > 0.0) {
        shares.push_back({from, to, whole(to) / units});
      }
    }
  }
  return shares;
}

}  // namespace

std::vector<TripPeriod> trip_shares(const City& city, const std::vector<DemandDay>& days) {
  const std::vector<Eigen::MatrixXd> counts = count_trips(city, days);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(city.size(), city.size());
  const Eigen::MatrixXd day = std::accumulate(counts.begin(), counts.end(), none,
                                              [](Eigen::MatrixXd sum, const auto& one) { return sum += one; });
  std::vector<TripPeriod> periods;
  for (const Eigen::MatrixXd& count : counts) {
    const int start = city.day_start + static_cast<int>(periods.size()) * period_minutes;
    periods.push_back({start, shares_of(count, day)});
  }
  return periods;
}

double share_within(const TripPeriod& period, int regions) {
  double within = 0.0;
  for (const TripShare& pair : period.shares) {
    within += pair.origin == pair.destination ? pair.share : 0.0;
  }
  return within / regions;
}

}  // namespace evbal

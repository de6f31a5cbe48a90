#include "tools/fit/transition_counts.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace evbal {
namespace {

constexpr double share_unit = 1e-6;

/// Rows of counts as shares, each together with `prior` cars that go as `likely` says.
Eigen::MatrixXd shrunk_shares(const Eigen::MatrixXd& counts, const Eigen::MatrixXd& likely, double prior) {
  const Eigen::VectorXd total = counts.rowwise().sum().array() + prior;
  return total.cwiseInverse().asDiagonal() * (counts + prior * likely);
}

/// Shares rounded to share_unit; the largest of each row takes what is missing to one.
Eigen::MatrixXd rounded_shares(const Eigen::MatrixXd& shares) {
  const double units = std::round(1.0 / share_unit);
  Eigen::MatrixXd whole = (shares * units).array().round();
  for (auto row : whole.rowwise()) {
    Eigen::Index largest = 0;
    row.maxCoeff(&largest);
    row(largest) += units - row.sum();
  }
  return whole / units;
}

Eigen::MatrixXd shares_of(const Eigen::MatrixXd& period, const Eigen::MatrixXd& day, double prior) {
  const Eigen::MatrixXd stay = Eigen::MatrixXd::Identity(day.rows(), day.cols());
  return rounded_shares(shrunk_shares(period, shrunk_shares(day, stay, prior), prior));
}

}  // namespace

const std::vector<int>& transition_periods() {
  static const std::vector<int> starts{5 * 60, 7 * 60, 10 * 60, 16 * 60, 19 * 60, 22 * 60};
  return starts;
}

std::size_t period_at(const std::vector<int>& starts, int minute) {
  const auto after = std::upper_bound(starts.begin(), starts.end(), minute);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - starts.begin()) - 1);
}

TransitionCounts::TransitionCounts(int regions)
    : vacant(Eigen::MatrixXd::Zero(regions, 3 * regions)), occupied(Eigen::MatrixXd::Zero(regions, 2 * regions)) {}

void TransitionCounts::add(const std::vector<CarPlace>& start, const std::vector<CarPlace>& end) {
  EVBAL_EXPECT(start.size() == end.size(), "the same cars at start and end");
  const Eigen::Index n = vacant.rows();
  for (std::size_t car = 0; car < start.size(); ++car) {
    const CarPlace& from = start[car];
    const CarPlace& to = end[car];
    const bool free = to.state == CarState::vacant || to.state == CarState::rebalancing;
    const bool busy = to.state == CarState::occupied;
    if (from.state == CarState::vacant) {
      vacant(from.region, (free ? 0 : busy ? n : 2 * n) + to.region) += 1.0;
    } else if (from.state == CarState::occupied) {
      occupied(from.region, (busy ? n : 0) + to.region) += 1.0;
    }
  }
}

TransitionCounts& TransitionCounts::operator+=(const TransitionCounts& other) {
  vacant += other.vacant;
  occupied += other.occupied;
  return *this;
}

Transitions transitions_of(const TransitionCounts& period, const TransitionCounts& day, double prior) {
  const Eigen::Index n = day.vacant.rows();
  const Eigen::MatrixXd p = shares_of(period.vacant, day.vacant, prior);
  const Eigen::MatrixXd q = shares_of(period.occupied, day.occupied, prior);
  return {p.leftCols(n), p.middleCols(n, n), p.rightCols(n), q.leftCols(n), q.rightCols(n)};
}

std::vector<Period> periods_of(const std::vector<TransitionCounts>& counts) {
  EVBAL_EXPECT(counts.size() == transition_periods().size(), "counts for each period");
  const TransitionCounts none(static_cast<int>(counts[0].vacant.rows()));
  const TransitionCounts day = std::accumulate(counts.begin(), counts.end(), none,
                                               [](TransitionCounts sum, const auto& one) { return sum += one; });
  std::vector<Period> periods;
  periods.reserve(counts.size());
  for (std::size_t p = 0; p < counts.size(); ++p) {
    periods.push_back({transition_periods()[p], transitions_of(counts[p], day, transition_prior)});
  }
  return periods;
}

}  // namespace evbal

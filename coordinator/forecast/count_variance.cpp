#include "coordinator/forecast/count_variance.hpp"

#include "coordinator/forecast/seasonal_fit.hpp"

#include <Eigen/Cholesky>

#include <algorithm>

namespace evbal {

CountVariance fit_count_variance(const std::vector<HeldOutDay>& days, int leads) {
  constexpr double least_variance = 0.25;  // of a count that is next to never seen
  CountVariance out;
  for (int lead = 0; lead < leads; ++lead) {
    Eigen::Matrix2d left = 1e-9 * Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const HeldOutDay& day : days) {
      const Eigen::Index n = day.forecasts.rows() / leads;
      const Eigen::ArrayXd m = day.forecasts.middleRows(lead * n, n).reshaped();
      const Eigen::ArrayXd squared = (day.counts.middleRows(lead * n, n).reshaped().array() - m).square();
      Eigen::MatrixXd design(m.size(), 2);
      design << m, m.square();
      const Eigen::VectorXd weight = (m + least_variance).square().inverse();
      left += design.transpose() * weight.asDiagonal() * design;
      right += design.transpose() * weight.cwiseProduct(squared.matrix());
    }
    const Eigen::Vector2d both = left.ldlt().solve(right);
    const bool concave = both(1) < 0.0;
    const double linear = concave ? right(0) / left(0, 0) : both(0);
    out.linear.push_back(std::max(1.0, linear));
    out.quadratic.push_back(concave ? 0.0 : both(1));
  }
  return out;
}

}  // namespace evbal

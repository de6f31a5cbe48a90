#include "coordinator/balancing/cumulative_demand.hpp"

#include "common/contract.hpp"
#include "coordinator/balancing/dropoffs.hpp"

#include <algorithm>

namespace evbal {

CumulativeDemand::CumulativeDemand(const PlanningData& data) : step_minutes_(data.step_minutes) {
  const Eigen::Index tau = data.points.cols();
  const Eigen::MatrixXd appear = data.demand.mean.cwiseMax(0.0).reshaped(data.km.rows(), tau);
  until_.resize(appear.rows(), tau + 1);
  until_.col(0) = still_there * data.state.waiting;
  for (Eigen::Index k = 0; k < tau; ++k) {
    until_.col(k + 1) = until_.col(k) + appear.col(k);
  }
}

double CumulativeDemand::within(double minutes, Eigen::Index region) const {
  EVBAL_EXPECT(minutes >= 0.0, "minutes from now");
  const double steps = minutes / step_minutes_;
  const Eigen::Index last = until_.cols() - 2;
  const Eigen::Index k = steps < static_cast<double>(last) ? static_cast<Eigen::Index>(steps) : last;
  const double before = until_(region, k);
  return before + (until_(region, k + 1) - before) * (steps - static_cast<double>(k));
}

}  // namespace evbal

#pragma once

#include "agents/protocol/messages.hpp"
#include "common/eigen.hpp"

#include <vector>

namespace evbal {

/// What the forecaster is told of faults of demand: what is active now, as if it lasted.
struct AnnouncedDemand {
  Eigen::VectorXd factor;  ///< N, on the passengers who usually appear
  Eigen::VectorXd added;   ///< N, passengers a minute beside these

  /// The usual counts (N) that would be seen as `counts` in so many minutes; not known better than `counts` where the
  /// factor leaves next to nothing, NaN where `counts` is.
  Eigen::VectorXd as_usual(const Eigen::VectorXd& counts, int minutes) const;

  /// Forecasts of usual demand, N x steps of so many minutes, as they are to be expected.
  Eigen::MatrixXd as_announced(const Eigen::MatrixXd& usual, int minutes) const;
};

/// Of the effects that are visible.
AnnouncedDemand announced_demand(const std::vector<Effect>& effects, int regions);

}  // namespace evbal

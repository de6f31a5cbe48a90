#pragma once

#include "agents/protocol/messages.hpp"
#include "common/eigen.hpp"

#include <vector>

namespace evbal {

/// What the forecaster is told of faults of demand: what is active now, as if it lasted.
struct AnnouncedDemand {
  Eigen::VectorXd factor;  ///< N, on the passengers who usually appear
  Eigen::VectorXd added;   ///< N, passengers a minute beside these

  /// The usual counts (N) that would be seen as `counts` in so many minutes: `counts` themselves where the factor is
  /// too small to tell, NaN where they are NaN.
  Eigen::VectorXd as_usual(const Eigen::VectorXd& counts, int minutes) const;

  /// What is to be expected where `usual`, N x steps of so many minutes, is the forecast of usual demand.
  Eigen::MatrixXd as_announced(const Eigen::MatrixXd& usual, int minutes) const;
};

/// What the visible ones among `effects` announce.
AnnouncedDemand announced_demand(const std::vector<Effect>& effects, int regions);

}  // namespace evbal

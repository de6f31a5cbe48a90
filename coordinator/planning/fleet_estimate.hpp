#pragma once

#include "agents/protocol/messages.hpp"
#include "common/eigen.hpp"
#include "coordinator/balancing/problem.hpp"

#include <optional>
#include <vector>

namespace evbal {

/// What the estimate knows of the city.
struct EstimateModel {
  Eigen::VectorXd points;              ///< installed, N
  Eigen::MatrixXd minutes;             ///< travel time, N x N
  double step_minutes = 30.0;          ///< Delta, that of the transitions
  double mean_session_minutes = 45.0;  ///< of charging
};

/// The fleet as the coordinator believes it to be: what regions report, and where no report can be believed, the last
/// uncertainty propagated by the model (docs/model.md, section 2) and the plans made since. Between two plans a share
/// of one step passes: of the transitions that share, of the charging sessions that which ends in the time.
class FleetEstimate {
 public:
  /// Knows of no vehicle yet.
  explicit FleetEstimate(EstimateModel model);

  /// Goes on to `minute`: the last plan's `moves` set off where there are vehicles, then the model's transitions.
  void advance(int minute, const std::vector<Move>& moves, const Transitions& transitions);

  /// Takes reports that are believed. Gives the reports of all regions, by region: these, and estimates of the others,
  /// whose `demand` and `completions` are 0.
  std::vector<Report> settle(int tick, const std::vector<std::optional<Report>>& good);

  /// Variance of the number of vacant vehicles in each region: 0 where it is reported; grows by the vehicles that are
  /// expected to come and go while it is not.
  const Eigen::VectorXd& variance() const { return variance_; }

 private:
  void set_off(const std::vector<Move>& moves);
  void arrive(int minute);
  void believe(const Report& report);
  Report estimated(int tick, int region) const;

  EstimateModel model_;
  int minute_ = 0;
  Eigen::VectorXd vacant_;
  Eigen::VectorXd occupied_;  ///< by destination
  Eigen::VectorXd low_battery_;
  Eigen::VectorXd plugged_;
  Eigen::VectorXd variance_;
  std::vector<Report> last_;  ///< believed of each region, `bound` kept up to date
};

}  // namespace evbal

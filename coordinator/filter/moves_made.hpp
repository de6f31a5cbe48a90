#pragma once

#include "agents/protocol/messages.hpp"
#include "common/eigen.hpp"

#include <vector>

namespace evbal {

/// Cars under way to each region, by region; of each by (minute, errand), those of the tick's own arrivals included.
std::vector<std::vector<UnderWay>> bound_for(const Tick& tick, int regions);

/// Cars of an errand among them.
int count_of(const std::vector<UnderWay>& bound, Errand errand);

/// What happened on the roads between two plans, by region.
struct RoadTraffic {
  Eigen::VectorXd came_vacant;  ///< cars that arrived with a passenger, or empty to serve
  Eigen::VectorXd came_low;     ///< cars that arrived to charge
  Eigen::VectorXd left_vacant;  ///< cars that a plan sent off to serve elsewhere
  Eigen::VectorXd left_low;     ///< likewise to charge elsewhere
  Eigen::VectorXd topped_up;    ///< vacant cars that a plan had queue for a charger
  Eigen::VectorXi may_stay;     ///< cars that were to leave, of those that are missing on the road
};

/// A plan that was made, and how things stood then.
struct PlanMade {
  int minute = 0;                            ///< at which its moves were to set off
  std::vector<Move> moves;                   ///< that agents were told of
  std::vector<std::vector<UnderWay>> bound;  ///< under way before it, by region
  Eigen::VectorXd vacant;                    ///< cars before it, N
  Eigen::VectorXd low_battery;               ///< likewise
  std::vector<bool> estimated;               ///< by region, whether these were not reported, or not believed
};

/// Works out the traffic from the last plan to minute `until`, at which `now` is under way. Moves are taken to have
/// been made; but of those whose cars are not on the road, from where cars were estimated in the first place, and of
/// those that would have arrived by now as far as there were cars for them. `minutes` are travel times, N x N, whole.
RoadTraffic traffic_since(const PlanMade& last, const std::vector<std::vector<UnderWay>>& now, int until,
                          const Eigen::MatrixXd& minutes);

}  // namespace evbal

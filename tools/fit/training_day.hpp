#pragma once

#include "agents/world/world.hpp"
#include "common/eigen.hpp"
#include "coordinator/planning/city_model.hpp"
#include "coordinator/planning/settings.hpp"
#include "tools/fit/transition_counts.hpp"

#include <vector>

namespace evbal {

/// What the plant did on a day.
struct TrainingDay {
  Eigen::MatrixXd completions;                ///< N x steps: charging sessions that ended charged
  std::vector<TransitionCounts> transitions;  ///< by period: that in which the step started
  int served = 0;                             ///< passengers
  int lost = 0;                               ///< passengers
  double idle_km = 0.0;                       ///< driven without passengers
};

/// Plays the world's day in this process, without faults.
TrainingDay play_training_day(const World& world, const CityModel& model, const PlanningSettings& settings,
                              const std::vector<int>& period_starts);

}  // namespace evbal

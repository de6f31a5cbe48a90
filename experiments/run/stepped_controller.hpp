#pragma once

#include "coordinator/planning/receding_horizon_planner.hpp"
#include "experiments/run/stepped_day.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// One of evbal's controllers beside a stepped day. It may plan at any moment, whoever planned before: it hears of
/// everything that was said and planned meanwhile.
class SteppedController {
 public:
  /// `day` must outlive it. Throws Error{bad_input} if there is no controller of this name, or the model does not fit.
  SteppedController(const SteppedDay& day, const std::string& name);

  /// The plan that it would make now. The day must not be over.
  Plan plan();

 private:
  void catch_up();

  const SteppedDay& day_;
  std::shared_ptr<RecedingHorizonPlanner> planner_;
  std::size_t heard_ = 0;     ///< of the day's plans
  std::optional<Plan> plan_;  ///< its own after those
};

/// A plan of somebody else's for tick(): the moves asked for, of which those cars are left out that a region does not
/// report. Where the report is not there or cannot be true, as many go as the region turns out to have. `moves` may be
/// in any order and name regions of the city only, each pair once an errand.
Plan plan_within_reports(const SteppedDay& day, std::vector<Move> moves, const std::string& controller);

}  // namespace evbal

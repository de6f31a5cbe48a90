#pragma once

#include "agents/protocol/messages.hpp"
#include "coordinator/balancing/problem.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// Solves the balancing problem of a controller.
using Balancer = std::function<BalancingResult(const std::string& controller, const PlanningData& data)>;

/// What is to be done now, in parts of vehicles; no region sends more than it has.
struct Decision {
  std::vector<Flow> vacant;
  std::vector<Flow> low_battery;
  Provenance provenance;  ///< without the engine's name
};

/// The fallback ladder (model, section 4): the controller itself, else nominal, else the next step of the last plan
/// that was solved, else nobody moves.
class Ladder {
 public:
  Ladder(std::string controller, Balancer balancer);

  Decision decide(const PlanningData& data);

 private:
  Decision solved(BalancingResult result, FallbackLevel level, std::string reason);
  Decision unsolved(const PlanningData& data, const std::string& reason);

  std::string controller_;
  Balancer balancer_;
  Dispatch last_;              ///< of the last solve that succeeded
  std::size_t next_step_ = 0;  ///< of last_, if this plan cannot be solved
  int failures_in_a_row_ = 0;
};

}  // namespace evbal

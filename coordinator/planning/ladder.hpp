#pragma once

#include "agents/protocol/messages.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/convex/engine.hpp"
#include "coordinator/planning/ladder_memory.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// Solves the balancing problem of a controller with an engine.
using Balancer = std::function<BalancingResult(const std::string& controller, const PlanningData& data,
                                               const EngineSettings& engine)>;

/// What is to be done now, in parts of vehicles; no region sends more than it has.
struct Decision {
  std::vector<Flow> vacant;       ///< by (from, to)
  std::vector<Flow> low_battery;  ///< by (from, to)
  std::vector<Flow> top_up;       ///< vacant cars that charge where they stand
  Provenance provenance;          ///< without the engine's name
};

/// The fallback ladder (docs/model.md, section 4): the controller itself, else nominal, else the step of the last plan
/// that was solved which covers the minute, else nobody moves. A step's vehicles are sent once, by the first decision
/// in it.
class Ladder {
 public:
  /// With no plan to fall back on yet.
  Ladder(std::string controller, Balancer balancer);

  /// `minute` of the day; never before that of the last call.
  Decision decide(int minute, const PlanningData& data, const EngineSettings& engine);

  /// What later decisions need of this one.
  const LadderMemory& memory() const { return memory_; }

  /// Goes on from where another ladder of the same controller was.
  void recall(LadderMemory memory) { memory_ = std::move(memory); }

 private:
  Decision solved(int minute, BalancingResult result, FallbackLevel level, std::string reason);
  Decision unsolved(int minute, const PlanningData& data, const std::string& reason);

  std::string controller_;
  Balancer balancer_;
  LadderMemory memory_;
};

}  // namespace evbal

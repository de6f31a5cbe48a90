#pragma once

#include "agents/protocol/messages.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/convex/engine.hpp"

#include <memory>
#include <string>
#include <vector>

namespace evbal::testing {

inline Tick at(int tick) {
  Tick announced;
  announced.tick = tick;
  announced.plan_due = true;
  return announced;
}

inline std::vector<Report> quiet_reports(int tick, int vacant) {
  std::vector<Report> reports(3);
  for (int i = 0; i < 3; ++i) {
    reports[static_cast<std::size_t>(i)].tick = tick;
    reports[static_cast<std::size_t>(i)].region = i;
    reports[static_cast<std::size_t>(i)].vacant = vacant;
  }
  return reports;
}

/// Keeps the last data it was asked to solve and moves nobody.
struct Spy {
  std::shared_ptr<PlanningData> seen = std::make_shared<PlanningData>();

  BalancingResult operator()(const std::string&, const PlanningData& data, const EngineSettings&) const {
    *seen = data;
    BalancingResult result;
    result.certificate.status = SolveStatus::optimal;
    return result;
  }
};

}  // namespace evbal::testing

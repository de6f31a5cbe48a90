#include "experiments/run/cross_check.hpp"

#include "common/interrupt.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/run/scenario_planner.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

const std::string other_engine = "ipopt";

/// Solves by the scenario's engine, notes in `checked` how far `ipopt` is from that, and gives the former's result.
Balancer checking(const PlanningSettings& settings, CrossChecked& checked) {
  return [solve = balancer_of(settings), &checked](const std::string& controller, const PlanningData& data,
                                                   const EngineSettings& engine) {
    BalancingResult own = solve(controller, data, engine);
    if (own.certificate.optimal() && own.certificate.iterations > 0) {
      const Certificate other = solve(controller, data, {.name = other_engine}).certificate;
      ++(other.optimal() ? checked.plans : checked.unsolved);
      if (other.optimal()) {
        const double apart = std::abs(own.certificate.objective - other.objective);
        checked.difference = std::max(checked.difference, apart / std::max(1.0, std::abs(other.objective)));
      }
    }
    return own;
  };
}

}  // namespace

std::optional<CrossChecked> cross_check(const Scenario& scenario, std::span<const TickRecord> ticks) {
  if (scenario.cross_check == CrossCheck::off || scenario.planning.engine.name == other_engine ||
      !scenario.planning.coordinator.empty()) {
    return std::nullopt;
  }
  CrossChecked checked{.engine = other_engine};
  const auto planner = planner_of(scenario, checking(scenario.planning, checked));
  for (const TickRecord& record : ticks) {
    if (record.exchange.plan) {
      planner->plan(record.tick, heard_in_time(record.tick, record.exchange.reports));
      check_interrupt();
    }
    const bool any = checked.plans + checked.unsolved > 0;
    if (scenario.cross_check == CrossCheck::first && any) {
      break;
    }
  }
  return checked.plans + checked.unsolved > 0 ? std::optional(checked) : std::nullopt;
}

}  // namespace evbal

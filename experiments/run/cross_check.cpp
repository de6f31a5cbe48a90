#include "experiments/run/cross_check.hpp"

#include "common/interrupt.hpp"
#include "experiments/run/scenario_planner.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

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

/// The reports that the coordinator heard.
std::vector<Report> heard(const TickRecord& record) {
  std::vector<Report> reports;
  const auto& unheard = record.tick.unheard;
  std::copy_if(
      record.exchange.reports.begin(), record.exchange.reports.end(), std::back_inserter(reports),
      [&](const Report& report) { return std::find(unheard.begin(), unheard.end(), report.region) == unheard.end(); });
  return reports;
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
      planner->plan(record.tick, heard(record));
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

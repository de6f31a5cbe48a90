#include "coordinator/planning/ladder.hpp"

#include <algorithm>
#include <utility>

namespace evbal {
namespace {

const std::string nominal = "nominal";

/// An old plan's flows, cut in proportion where a region has fewer vehicles than they ask for.
std::vector<Flow> within(std::vector<Flow> flows, const Eigen::VectorXd& available) {
  Eigen::VectorXd asked = Eigen::VectorXd::Zero(available.size());
  for (const Flow& flow : flows) {
    asked(flow.from) += flow.amount;
  }
  for (Flow& flow : flows) {
    flow.amount *= std::min(1.0, available(flow.from) / std::max(asked(flow.from), 1e-9));
  }
  return flows;
}

std::vector<Flow> step_of(const std::vector<std::vector<Flow>>& steps, std::size_t step) {
  return step < steps.size() ? steps[step] : std::vector<Flow>{};
}

std::size_t steps_of(const Dispatch& dispatch) {
  return std::max(dispatch.vacant.size(), dispatch.low_battery.size());
}

std::vector<PlanCost> by_term(const std::vector<CostTerm>& terms) {
  std::vector<PlanCost> costs;
  costs.reserve(terms.size());
  for (const auto& [name, cost] : terms) {
    costs.push_back({name, cost});
  }
  return costs;
}

}  // namespace

Ladder::Ladder(std::string controller, Balancer balancer)
    : controller_(std::move(controller)), balancer_(std::move(balancer)) {}

Decision Ladder::decide(int minute, const PlanningData& data, const EngineSettings& engine) {
  BalancingResult first = balancer_(controller_, data, engine);
  if (first.certificate.optimal()) {
    return solved(minute, std::move(first), FallbackLevel::none, "");
  }
  std::string reason = controller_ + ": " + first.certificate.reason;
  if (controller_ != nominal) {
    BalancingResult second = balancer_(nominal, data, engine);
    if (second.certificate.optimal()) {
      return solved(minute, std::move(second), FallbackLevel::nominal, std::move(reason));
    }
    reason += "; " + nominal + ": " + second.certificate.reason;
  }
  return unsolved(minute, data, reason);
}

Decision Ladder::solved(int minute, BalancingResult result, FallbackLevel level, std::string reason) {
  memory_ = {.last = std::move(result.dispatch),
             .minute = minute,
             .next_step = 1,
             .failures_in_a_row = 0,
             .start = std::move(result.start)};
  const Certificate& certificate = result.certificate;
  return {step_of(memory_.last.vacant, 0),
          step_of(memory_.last.low_battery, 0),
          memory_.last.top_up,
          {.controller = controller_,
           .engine = {},
           .fallback = level,
           .reason = std::move(reason),
           .objective = certificate.objective,
           .lower_bound = certificate.lower_bound,
           .gap = certificate.gap,
           .max_violation = certificate.max_violation,
           .iterations = certificate.iterations,
           .costs = by_term(result.cost)}};
}

Decision Ladder::unsolved(int minute, const PlanningData& data, const std::string& reason) {
  const Dispatch& last = memory_.last;
  ++memory_.failures_in_a_row;
  Decision decision;
  decision.provenance.controller = controller_;
  decision.provenance.fallback = FallbackLevel::hold;
  decision.provenance.reason = reason + "; failures in a row: " + std::to_string(memory_.failures_in_a_row);
  const auto step = static_cast<std::size_t>((minute - memory_.minute) / data.step_minutes);
  if (step < steps_of(last)) {
    decision.provenance.fallback = FallbackLevel::shifted;
  }
  if (step < steps_of(last) && step >= memory_.next_step) {
    decision.vacant = within(step_of(last.vacant, step), data.state.vacant);
    decision.low_battery = within(step_of(last.low_battery, step), data.state.low_battery);
    memory_.next_step = step + 1;
  }
  return decision;
}

}  // namespace evbal

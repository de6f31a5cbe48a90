#include "coordinator/balancing/controllers.hpp"

#include "common/contract.hpp"
#include "coordinator/balancing/formulation.hpp"
#include "coordinator/balancing/heuristics.hpp"
#include "coordinator/balancing/validate.hpp"
#include "coordinator/convex/certificate.hpp"

#include <algorithm>
#include <utility>

namespace evbal {

namespace {

// What the next plan starts from. Of `flow` the curves alone: in its slots, which move on with every plan, the last
// basis costs more than it saves.
Start carried_on(const Start& last, const FormulationOptions& options) {
  return options.shortage == Shortage::flow ? Start{.basic = {}, .at_upper = {}, .binding = {}, .curves = last.curves}
                                            : last;
}

}  // namespace

PlanFunction optimum(const FormulationOptions& options) {
  return [options](const BalancingParameters& parameters, const PlanningData& data, const EngineSettings& engine) {
    const Formulation formulation = formulate(parameters, data, options);
    const Solution solution = solve(formulation.program, engine, carried_on(data.start, options));
    if (!solution.certificate.optimal()) {
      return BalancingResult{.dispatch = {}, .certificate = solution.certificate, .cost = {}};
    }
    return BalancingResult{.dispatch = dispatch_at(formulation, solution.x),
                           .certificate = solution.certificate,
                           .cost = formulation.program.cost_by_term(solution.x),
                           .start = carried_on(solution.start, options)};
  };
}

BalancingResult by_rule(Dispatch dispatch) {
  BalancingResult result{.dispatch = std::move(dispatch), .certificate = {}, .cost = {}};
  result.certificate.status = SolveStatus::optimal;
  return result;
}

const std::vector<Controller>& controllers() {
  const auto none = [](const auto& /*parameters*/, const PlanningData& data, const auto& /*engine*/) {
    return by_rule(plan_none(data));
  };
  const auto greedy = [](const BalancingParameters& parameters, const PlanningData& data, const auto& /*engine*/) {
    return by_rule(plan_greedy(parameters, data));
  };
  static const std::vector<Controller> all = {
      {.name = "none", .plan = none, .about = "sends low-battery cars to the nearest charger, nobody else"},
      {.name = "greedy", .plan = greedy, .about = "sends cars to the nearest shortage and to the soonest charger"},
      {.name = "nominal",
       .plan = optimum({Shortage::band, Uncertainty::mean, Uncertainty::mean}),
       .about = "trusts its forecasts: the paper's rival"},
      {.name = "demand-robust",
       .plan = optimum({Shortage::band, Uncertainty::worst_case, Uncertainty::mean}),
       .about = "robust against demand alone"},
      {.name = "robust",
       .plan = optimum({Shortage::band, Uncertainty::worst_case, Uncertainty::worst_case}),
       .about = "robust against demand and supply: the paper's method"},
      {.name = "moment",
       .plan = optimum({Shortage::moments, Uncertainty::worst_case, Uncertainty::worst_case}),
       .about = "the worst expected shortage over all laws of the uncertainty set"},
      {.name = "scenario",
       .plan = optimum({Shortage::band, Uncertainty::samples, Uncertainty::mean}),
       .draws_samples = true,
       .about = "the mean over 50 samples of demand"},
      {.name = "ratio",
       .plan = optimum({Shortage::ratio, Uncertainty::mean, Uncertainty::mean}),
       .about = "passengers per vehicle: the strongest deterministic rival"},
      {.name = "turnover",
       .plan = optimum({Shortage::turnover, Uncertainty::counts, Uncertainty::mean}),
       .about = "prices a shortage as the passengers who would be lost, drop-offs counted"},
      {.name = "flow",
       .plan = optimum({Shortage::flow, Uncertainty::counts, Uncertainty::mean}),
       .about = "plans by the minute in which each car arrives, drop-offs and ends of charging counted"},
      {.name = "oracle",
       .plan = optimum({Shortage::turnover, Uncertainty::counts, Uncertainty::mean}),
       .foresees = true,
       .about = "`turnover`, told what the demand will be"},
      {.name = "flow-oracle",
       .plan = optimum({Shortage::flow, Uncertainty::counts, Uncertainty::mean}),
       .foresees = true,
       .about = "`flow`, told what the demand will be"},
  };
  return all;
}

BalancingResult balance(const Controller& controller, const BalancingParameters& parameters, const PlanningData& data,
                        const EngineSettings& engine) {
  if (const auto why_not = validate(parameters, data); !why_not.empty()) {
    return {.dispatch = {}, .certificate = refusal(why_not, SolveStatus::refused), .cost = {}};
  }
  return controller.plan(parameters, data, engine);
}

BalancingResult balance(const std::string& controller, const BalancingParameters& parameters, const PlanningData& data,
                        const EngineSettings& engine) {
  const auto chosen = std::ranges::find(controllers(), controller, &Controller::name);
  EVBAL_EXPECT(chosen != controllers().end(), "the name of a controller");
  return balance(*chosen, parameters, data, engine);
}

bool draws_samples(const std::string& controller) {
  const auto known = std::ranges::find(controllers(), controller, &Controller::name);
  return known == controllers().end() || known->draws_samples;
}

bool foresees(const std::string& controller, const std::vector<Controller>& own) {
  for (const auto* known : {&own, &controllers()}) {
    const auto found = std::ranges::find(*known, controller, &Controller::name);
    if (found != known->end()) {
      return found->foresees;
    }
  }
  return false;
}

std::vector<std::string> controller_names() {
  std::vector<std::string> names;
  names.reserve(controllers().size());
  for (const auto& controller : controllers()) {
    names.push_back(controller.name);
  }
  return names;
}

}  // namespace evbal

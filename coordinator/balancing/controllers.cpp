#include "coordinator/balancing/controllers.hpp"

#include "coordinator/balancing/certificate.hpp"
#include "coordinator/balancing/formulation.hpp"
#include "coordinator/balancing/heuristics.hpp"
#include "coordinator/balancing/soundness.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace evbal {
namespace {

using Plan = BalancingResult (*)(const BalancingParameters&, const PlanningData&, const EngineSettings&);

struct Controller {
  const char* name;
  Plan plan;
};

// The balancing problem with one setting of its switches.
template <Switches switches>
BalancingResult optimum(const BalancingParameters& parameters, const PlanningData& data, const EngineSettings& engine) {
  const Formulation formulation = formulate(parameters, data, switches);
  const Solution solution = solve(formulation.program, engine);
  if (!solution.certificate.optimal) {
    return {.dispatch = {}, .certificate = solution.certificate};
  }
  return {.dispatch = dispatch_at(formulation, solution.x), .certificate = solution.certificate};
}

Certificate nothing_to_solve() {
  Certificate certificate;
  certificate.optimal = true;
  return certificate;
}

BalancingResult none(const BalancingParameters& /*parameters*/, const PlanningData& data,
                     const EngineSettings& /*engine*/) {
  return {.dispatch = plan_none(data), .certificate = nothing_to_solve()};
}

BalancingResult greedy(const BalancingParameters& parameters, const PlanningData& data,
                       const EngineSettings& /*engine*/) {
  return {.dispatch = plan_greedy(parameters, data), .certificate = nothing_to_solve()};
}

// Model, section 4.
constexpr std::array controllers = {
    Controller{"none", none},
    Controller{"greedy", greedy},
    Controller{"nominal", optimum<Switches{Shortage::band, Belief::mean, Belief::mean}>},
    Controller{"demand-robust", optimum<Switches{Shortage::band, Belief::worst_case, Belief::mean}>},
    Controller{"robust", optimum<Switches{Shortage::band, Belief::worst_case, Belief::worst_case}>},
    Controller{"moment", optimum<Switches{Shortage::moments, Belief::worst_case, Belief::worst_case}>},
    Controller{"scenario", optimum<Switches{Shortage::band, Belief::samples, Belief::mean}>},
    Controller{"ratio", optimum<Switches{Shortage::ratio, Belief::mean, Belief::mean}>},
    Controller{"turnover", optimum<Switches{Shortage::turnover, Belief::counts, Belief::mean}>},
    Controller{"oracle", optimum<Switches{Shortage::turnover, Belief::counts, Belief::mean}>},  // on true forecasts
};

}  // namespace

BalancingResult balance(const std::string& controller, const BalancingParameters& parameters, const PlanningData& data,
                        const EngineSettings& engine) {
  const auto* chosen = std::ranges::find_if(controllers, [&](const auto& c) { return c.name == controller; });
  assert(chosen != controllers.end());
  if (const auto why_not = complaint(parameters, data); !why_not.empty()) {
    return {.dispatch = {}, .certificate = refusal(why_not)};
  }
  return chosen->plan(parameters, data, engine);
}

std::vector<std::string> controller_names() {
  std::vector<std::string> names;
  names.reserve(controllers.size());
  for (const auto& controller : controllers) {
    names.emplace_back(controller.name);
  }
  return names;
}

}  // namespace evbal

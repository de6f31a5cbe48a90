#pragma once

#include "coordinator/balancing/problem.hpp"
#include "coordinator/balancing/uncertainty_model.hpp"
#include "coordinator/convex/engine.hpp"

#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// Makes one plan from data that are sound (validate.hpp).
using PlanFunction =
    std::function<BalancingResult(const BalancingParameters&, const PlanningData&, const EngineSettings&)>;

/// A way to plan.
struct Controller {
  std::string name;            ///< that scenarios use
  PlanFunction plan;           ///< how it plans
  bool draws_samples = false;  ///< plans for PlanningData::demand_samples
  bool foresees = false;       ///< is told the true demand in place of a forecast
  std::string about{};         ///< what it is, in a line
};

/// Solves the balancing problem with these options.
PlanFunction optimum(const FormulationOptions& options);

/// A plan of these flows that nothing was solved for: objective, bound and gap are 0, and there are no cost terms.
BalancingResult by_rule(Dispatch dispatch);

/// The project's own controllers (docs/model.md, section 4).
const std::vector<Controller>& controllers();

/// Makes one plan over the horizon that `data` spans; `engine.name` is one of engine_names(). Never throws for what the
/// data hold: data that are no numbers and solves that fail give a certificate that is not optimal and says why; the
/// plan is then empty.
BalancingResult balance(const Controller& controller, const BalancingParameters& parameters, const PlanningData& data,
                        const EngineSettings& engine);

/// The same by one of controller_names().
BalancingResult balance(const std::string& controller, const BalancingParameters& parameters, const PlanningData& data,
                        const EngineSettings& engine);

/// Whether this controller plans for PlanningData::demand_samples, of which it needs one at least; a name that is not
/// among controllers() may.
bool draws_samples(const std::string& controller);

/// Whether this controller, one of `own` or of controllers(), is told the true demand; false if it is neither.
bool foresees(const std::string& controller, const std::vector<Controller>& own = {});

/// Names of controllers(), in their order.
std::vector<std::string> controller_names();

}  // namespace evbal

// What must hold of every controller that solves the balancing problem, whatever the data.

#include "coordinator/balancing/controllers.hpp"
#include "tests/balancing/solving_controllers.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

double optimum_by_any_engine(const std::string& controller, const PlanningData& data,
                             const BalancingParameters& parameters) {
  const EngineSettings engine{.name = *rc::gen::elementOf(engine_names())};
  const auto certificate = balance(controller, parameters, data, engine).certificate;
  RC_ASSERT(certificate.optimal());
  return certificate.objective;
}

PlanningData any_data(int tau) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const int regions = *rc::gen::inRange(1, 7);
  return random_planning_data(seed, {.regions = regions, .tau = tau, .chargeable_share = *rc::gen::element(0.0, 0.5)});
}

BalancingParameters any_parameters() {
  BalancingParameters parameters;
  parameters.supply = *rc::gen::element(Supply::completions, Supply::points);
  parameters.flow_value = *rc::gen::element(0.0, 0.6);
  return parameters;
}

using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic>;

// `one` for every step, of vectors that stand step-major.
Permutation stacked(const Permutation& one, Eigen::Index tau) {
  const Eigen::Index n = one.rows();
  Permutation all(n * tau);
  for (Eigen::Index i = 0; i < n * tau; ++i) {
    all.indices()(i) = static_cast<int>(i / n * n) + one.indices()(i % n);
  }
  return all;
}

PlanningData renamed(PlanningData data, const Permutation& one) {
  const Permutation all = stacked(one, data.points.cols());
  const auto square = [&](Eigen::MatrixXd& m) { m = (one * m * one.transpose()).eval(); };
  const auto rows = [&](auto& m) { m = (one * m).eval(); };
  square(data.km);
  square(data.minutes);
  square(data.turnover.same_step_dropoffs);
  for (auto* vector : {&data.state.vacant, &data.state.chargeable, &data.state.occupied, &data.state.low_battery,
                       &data.state.plugged, &data.state.waiting, &data.worth.vacant, &data.worth.serving}) {
    rows(*vector);
  }
  auto reach = data.state.reach;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    data.state.reach[static_cast<std::size_t>(one.indices()(static_cast<Eigen::Index>(i)))] = reach[i];
  }
  for (auto* matrix : {&data.state.arriving_vacant, &data.state.arriving_low_battery, &data.state.dropoffs_due,
                       &data.points, &data.freed.mean, &data.freed.variance}) {
    rows(*matrix);
  }
  for (auto* set : {&data.demand, &data.completions, &data.free_points}) {
    set->mean = (all * set->mean).eval();
    set->deviation = (all * set->deviation).eval();
    set->factors = (all * set->factors).eval();
  }
  data.demand_samples = (all * data.demand_samples).eval();
  for (auto& move : data.transitions) {
    for (auto* matrix : {&move.vacant_to_vacant, &move.vacant_to_occupied, &move.vacant_to_low_battery,
                         &move.occupied_to_vacant, &move.occupied_to_occupied}) {
      square(*matrix);
    }
  }
  return data;
}

RC_GTEST_PROP(ControllersProperty, NamesOfRegionsDoNotMatter, ()) {
  const auto data = any_data(2);
  const auto parameters = any_parameters();
  Permutation one(data.km.rows());
  one.setIdentity();
  for (int i = 0; i < one.size(); ++i) {
    std::swap(one.indices()(i), one.indices()(*rc::gen::inRange(i, static_cast<int>(one.size()))));
  }
  const auto controller = *rc::gen::elementOf(solving_controllers());
  const double expected = optimum_by_any_engine(controller, data, parameters);
  RC_ASSERT(std::abs(optimum_by_any_engine(controller, renamed(data, one), parameters) - expected) <=
            2e-6 * std::max(1.0, std::abs(expected)));
}

RC_GTEST_PROP(ControllersProperty, CostByTermIsTheObjective, ()) {
  const auto data = any_data(*rc::gen::inRange(1, 3));
  const auto parameters = any_parameters();
  const auto controller = *rc::gen::elementOf(controller_names());
  const EngineSettings engine{.name = *rc::gen::elementOf(engine_names())};
  const auto result = balance(controller, parameters, data, engine);
  RC_ASSERT(result.certificate.optimal());
  double sum = 0.0;
  for (const CostTerm& term : result.cost) {
    RC_ASSERT(term.cost >= -1e-6);
    sum += term.cost;
  }
  const double objective = result.certificate.objective;
  RC_ASSERT(std::abs(sum - objective) <= 1e-9 * std::max(1.0, std::abs(objective)));
}

// Other units of length: km, reach and every price by one factor.
RC_GTEST_PROP(ControllersProperty, UnitsOfLengthDoNotMatter, ()) {
  auto data = any_data(2);
  auto parameters = any_parameters();
  const auto controller = *rc::gen::elementOf(solving_controllers());
  const double factor = *rc::gen::element(0.1, 0.5, 1.6, 7.0);
  const double expected = factor * optimum_by_any_engine(controller, data, parameters);
  data.km *= factor;
  data.worth.vacant *= factor;
  data.worth.serving *= factor;
  for (auto price : {&BalancingParameters::m1, &BalancingParameters::flow_m1, &BalancingParameters::m2,
                     &BalancingParameters::theta_0, &BalancingParameters::omega, &BalancingParameters::pi_e,
                     &BalancingParameters::p_shortage, &BalancingParameters::p_surplus, &BalancingParameters::p_ratio,
                     &BalancingParameters::p_flow, &BalancingParameters::top_up}) {
    parameters.*price *= factor;
  }
  data.state.plugged = data.state.plugged.cwiseMin(data.points.rowwise().minCoeff());  // z costs the same in any unit
  RC_ASSERT(std::abs(optimum_by_any_engine(controller, data, parameters) - expected) <=
            2e-6 * std::max(1.0, std::abs(expected)));
}

// At fixed h, without a surplus. With one step the band stands at  h = (1 + eta) sum r / sum V.
RC_GTEST_PROP(ControllersProperty, MoreVehiclesNeverCostMore, ()) {
  auto data = any_data(1);
  data.worth = {};  // else each vehicle costs what it would be worth more elsewhere
  const double fleet = data.state.vacant.sum();
  RC_PRE(fleet >= 1.0);
  auto more = data;
  more.state.vacant(*rc::gen::inRange<Eigen::Index>(0, data.km.rows())) +=
      *rc::gen::inRange(1, 1 + static_cast<int>(fleet));
  auto parameters = any_parameters();
  parameters.p_surplus = 0.0;
  parameters.eta = 0.0;
  const auto controller = *rc::gen::elementOf(solving_controllers());
  const double before = optimum_by_any_engine(controller, data, parameters);
  parameters.eta = more.state.vacant.sum() / fleet - 1.0;
  RC_ASSERT(optimum_by_any_engine(controller, more, parameters) <= before + 2e-6 * std::max(1.0, std::abs(before)));
}

}  // namespace
}  // namespace evbal

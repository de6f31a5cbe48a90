#include "coordinator/balancing/validate.hpp"

#include "coordinator/balancing/controllers.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace evbal {
namespace {

struct Datum {
  std::string name;
  std::function<double&(PlanningData&, BalancingParameters&)> at;
};

// One of each kind of number that a plan is made from.
std::vector<Datum> all_data() {
  return {
      {"vacant", [](auto& d, auto&) -> double& { return d.state.vacant(1); }},
      {"occupied", [](auto& d, auto&) -> double& { return d.state.occupied(1); }},
      {"low_battery", [](auto& d, auto&) -> double& { return d.state.low_battery(1); }},
      {"plugged", [](auto& d, auto&) -> double& { return d.state.plugged(0); }},
      {"waiting", [](auto& d, auto&) -> double& { return d.state.waiting(2); }},
      {"chargeable", [](auto& d, auto&) -> double& { return d.state.chargeable(0); }},
      {"reach",
       [](auto& d, auto&) -> double& {
         d.state.low_battery(1) = 4.0;
         return d.state.reach[1].emplace_back();
       }},
      {"arriving_vacant", [](auto& d, auto&) -> double& { return d.state.arriving_vacant(0, 1); }},
      {"dropoffs_due", [](auto& d, auto&) -> double& { return d.state.dropoffs_due(0, 1); }},
      {"points", [](auto& d, auto&) -> double& { return d.points(0, 0); }},
      {"km", [](auto& d, auto&) -> double& { return d.km(0, 1); }},
      {"minutes", [](auto& d, auto&) -> double& { return d.minutes(0, 1); }},
      {"demand mean", [](auto& d, auto&) -> double& { return d.demand.mean(1); }},
      {"demand deviation", [](auto& d, auto&) -> double& { return d.demand.deviation(1); }},
      {"demand factor", [](auto& d, auto&) -> double& { return d.demand.factors(1, 0); }},
      {"demand g1", [](auto& d, auto&) -> double& { return d.demand.g1; }},
      {"demand g2", [](auto& d, auto&) -> double& { return d.demand.g2; }},
      {"demand sample", [](auto& d, auto&) -> double& { return d.demand_samples(1, 0); }},
      {"completions mean", [](auto& d, auto&) -> double& { return d.completions.mean(0); }},
      {"completions deviation", [](auto& d, auto&) -> double& { return d.completions.deviation(0); }},
      {"completions factor", [](auto& d, auto&) -> double& { return d.completions.factors(0, 1); }},
      {"completions g1", [](auto& d, auto&) -> double& { return d.completions.g1; }},
      {"completions g2", [](auto& d, auto&) -> double& { return d.completions.g2; }},
      {"variance, linear", [](auto& d, auto&) -> double& { return d.turnover.demand.linear[0]; }},
      {"variance, quadratic", [](auto& d, auto&) -> double& { return d.turnover.demand.quadratic[0]; }},
      {"freed", [](auto& d, auto&) -> double& { return d.freed.mean(1, 2); }},
      {"freed, variance", [](auto& d, auto&) -> double& { return d.freed.variance(1, 2); }},
      {"worth, vacant", [](auto& d, auto&) -> double& { return d.worth.vacant(1); }},
      {"worth, serving", [](auto& d, auto&) -> double& { return d.worth.serving(0); }},
      {"step_minutes", [](auto& d, auto&) -> double& { return d.step_minutes; }},
      {"mean_session_minutes", [](auto& d, auto&) -> double& { return d.mean_session_minutes; }},
      {"a", [](auto&, auto& p) -> double& { return p.a; }},
      {"theta_0", [](auto&, auto& p) -> double& { return p.theta_0; }},
      {"eps", [](auto&, auto& p) -> double& { return p.eps; }},
      {"beta", [](auto&, auto& p) -> double& { return p.beta; }},
      {"omega", [](auto&, auto& p) -> double& { return p.omega; }},
      {"pi_e", [](auto&, auto& p) -> double& { return p.pi_e; }},
      {"p_shortage", [](auto&, auto& p) -> double& { return p.p_shortage; }},
      {"p_surplus", [](auto&, auto& p) -> double& { return p.p_surplus; }},
      {"p_ratio", [](auto&, auto& p) -> double& { return p.p_ratio; }},
      {"p_flow", [](auto&, auto& p) -> double& { return p.p_flow; }},
      {"flow_end", [](auto&, auto& p) -> double& { return p.flow_end; }},
      {"flow_value", [](auto&, auto& p) -> double& { return p.flow_value; }},
  };
}

// Whatever one number is, each controller plans or says why not: no library ends the process.
TEST(Validate, NoNumberEndsTheProcess) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<std::string, std::string>> solves = {
      {"robust", "ipopt"}, {"robust", "cuts"},   {"moment", "cuts"}, {"scenario", "cuts"},
      {"ratio", "cuts"},   {"turnover", "cuts"}, {"flow", "cuts"}};
  for (const auto& datum : all_data()) {
    for (const double value : {0.0, 1e-300, 1e-3, 1e3, 1e6, 1e100, infinity, std::nan("")}) {
      auto data = random_planning_data(1, {.regions = 3, .tau = 2, .rank = 2});
      BalancingParameters parameters;
      datum.at(data, parameters) = value;
      for (const auto& [controller, engine] : solves) {
        const auto result = balance(controller, parameters, data, {.name = engine, .max_iterations = 10});
        EXPECT_EQ(result.certificate.optimal(), result.certificate.reason.empty());
        EXPECT_TRUE(!result.certificate.optimal() || std::isfinite(result.certificate.objective))
            << datum.name << " = " << value << ", " << controller << " by " << engine;
      }
    }
  }
}

// Far beyond what a city has, and short of what a solver takes.
TEST(Validate, RefusesWhatIsBeyondAnyCity) {
  for (const auto& datum : all_data()) {
    for (const double value : {1e20, 1e100}) {
      auto data = random_planning_data(1, {.regions = 3, .tau = 2, .rank = 2});
      BalancingParameters parameters;
      datum.at(data, parameters) = value;
      EXPECT_NE(validate(parameters, data), "") << datum.name << " = " << value;
    }
  }
  auto data = random_planning_data(1, {.regions = 3});
  data.km(0, 1) = data.minutes(0, 1) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(validate({}, data), "") << "no road";
}

// A count that is as wide as it may be still has few values.
TEST(Validate, RefusesADemandWithoutEnd) {
  auto data = random_planning_data(1, {.regions = 3});
  data.demand.mean(1) = 1e6;
  data.turnover.demand.quadratic = {100.0, 100.0};
  EXPECT_TRUE(validate({}, data).starts_with("variance of demand over its mean"));
}

}  // namespace
}  // namespace evbal

#include "coordinator/balancing/controllers.hpp"
#include "coordinator/planning/receding_horizon_planner.hpp"
#include "tests/planning/planner_fixture.hpp"
#include "tests/planning/small_city.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <set>
#include <utility>

namespace evbal {
namespace {

using testing::at;
using testing::quiet_reports;

/// Solves once, for a plan of two steps, and never again.
struct SolvesOnce {
  std::shared_ptr<bool> solved = std::make_shared<bool>(false);

  BalancingResult operator()(const std::string&, const PlanningData&, const EngineSettings&) const {
    BalancingResult result;
    result.certificate.status = std::exchange(*solved, true) ? SolveStatus::failed : SolveStatus::optimal;
    result.dispatch.vacant = {{{0, 1, 2.0}}, {{1, 2, 3.0}}};
    return result;
  }
};

using Moves = std::vector<std::array<int, 3>>;  // from, to, vehicles

Moves moves_of(const Plan& plan) {
  Moves moves;
  for (const Move& move : plan.moves) {
    moves.push_back({move.from, move.to, move.count});
  }
  return moves;
}

// Plans are due every 10 minutes, a step lasts 30.
TEST(RecedingHorizonPlanner, ShiftsTheLastPlanByTheTimeThatPassed) {
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, testing::small_model(), SolvesOnce{});
  const auto made_at = [&](int tick) { return planner.plan(at(tick), quiet_reports(tick, 9)); };
  EXPECT_EQ(moves_of(made_at(0)), (Moves{{0, 1, 2}}));
  for (const int tick : {2, 4, 8, 10}) {
    if (tick == 8) {
      EXPECT_EQ(moves_of(made_at(6)), (Moves{{1, 2, 3}})) << "the second step begins";
    }
    const Plan plan = made_at(tick);
    EXPECT_EQ(plan.provenance.fallback, FallbackLevel::shifted) << tick;
    EXPECT_TRUE(plan.moves.empty()) << "the step's vehicles have been sent, tick " << tick;
  }
  EXPECT_EQ(made_at(12).provenance.fallback, FallbackLevel::hold) << "the last plan is over";
}

// A coordinator that was dead when the second step began sends its vehicles off as it comes back, and once.
TEST(RecedingHorizonPlanner, ShiftsByTheTimeThatPassedWhileItWasDead) {
  RecedingHorizonPlanner dead(testing::small_city(), {}, testing::date, {}, testing::small_model(), SolvesOnce{});
  dead.plan(at(0), quiet_reports(0, 9));
  const auto back = [&] {
    const SolvesOnce never{std::make_shared<bool>(true)};
    RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, testing::small_model(), never);
    planner.recall(at(0), quiet_reports(0, 9), dead.memory());
    return planner;
  };
  EXPECT_EQ(back().plan(at(12), quiet_reports(12, 9)).provenance.fallback, FallbackLevel::hold);
  RecedingHorizonPlanner planner = back();
  EXPECT_EQ(moves_of(planner.plan(at(8), quiet_reports(8, 9))), (Moves{{1, 2, 3}}));
  EXPECT_TRUE(planner.plan(at(10), quiet_reports(10, 9)).moves.empty());
  EXPECT_EQ(planner.plan(at(12), quiet_reports(12, 9)).provenance.fallback, FallbackLevel::hold);
}

Provenance provenance_under(const Effect& effect, const std::string& controller, const std::string& engine) {
  PlanningSettings settings;
  settings.controller = controller;
  settings.engine.name = engine;
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, settings, testing::small_model());
  Tick tick = at(0);
  tick.effects = {effect};
  return planner.plan(tick, quiet_reports(0, 5)).provenance;
}

TEST(RecedingHorizonPlanner, GoesDownTheLadderWhenTheEngineFails) {
  const Effect fail{.type = EffectType::solver_fail, .region = no_region};
  for (const std::string engine : {"ipopt", "cuts"}) {
    const Provenance failed = provenance_under(fail, "robust", engine);
    EXPECT_EQ(failed.fallback, FallbackLevel::hold);
    EXPECT_NE(failed.reason.find("by a fault"), std::string::npos) << failed.reason;
    const Effect starve{.type = EffectType::solver_starve, .region = no_region, .magnitude = 1.0};
    const Provenance starved = provenance_under(starve, "robust", engine);
    EXPECT_LE(starved.iterations, 1) << engine;
    EXPECT_EQ(starved.fallback, engine == "ipopt" ? FallbackLevel::hold : FallbackLevel::none)
        << "one linear program may do";
    const Effect plenty{.type = EffectType::solver_starve, .region = no_region, .magnitude = 1e6};
    EXPECT_EQ(provenance_under(plenty, "robust", engine).fallback, FallbackLevel::none);
  }
  EXPECT_EQ(provenance_under(fail, "greedy", "ipopt").fallback, FallbackLevel::none) << "solves nothing";
}

// By both engines: what the coordinator does when its controller fails, then nominal too, and goes on failing.
TEST(RecedingHorizonPlanner, ComesDownTheLadderAndUpAgain) {
  for (const std::string& engine : engine_names()) {
    PlanningSettings settings;
    settings.engine.name = engine;
    std::set<std::string> failing;
    RecedingHorizonPlanner planner(
        testing::small_city(), {}, testing::date, settings, testing::small_model(),
        [&failing, solve = balancer_of(settings)](const std::string& controller, const PlanningData& data,
                                                  const EngineSettings& given) {
          return failing.contains(controller) ? BalancingResult{} : solve(controller, data, given);
        });
    const auto level_of = [&](int tick, const std::set<std::string>& fail) {
      failing = fail;
      const Plan plan = planner.plan(at(tick), quiet_reports(tick, 5));
      EXPECT_EQ(plan.provenance.controller, "robust");
      EXPECT_EQ(plan.provenance.reason.empty(), fail.empty());
      EXPECT_LE(plan.provenance.gap, 1e-6);
      double sum = 0.0;
      for (const PlanCost& cost : plan.provenance.costs) {
        sum += cost.cost;
      }
      EXPECT_NEAR(sum, plan.provenance.objective, 1e-9 * std::max(1.0, sum));
      EXPECT_EQ(plan.provenance.engine, plan.provenance.fallback <= FallbackLevel::nominal ? engine : "");
      return plan.provenance.fallback;
    };
    EXPECT_EQ(level_of(0, {}), FallbackLevel::none) << engine;
    EXPECT_EQ(level_of(2, {"robust"}), FallbackLevel::nominal) << engine;
    EXPECT_EQ(level_of(4, {"robust", "nominal"}), FallbackLevel::shifted) << engine;
    EXPECT_EQ(level_of(14, {"robust", "nominal"}), FallbackLevel::hold) << engine;
    EXPECT_EQ(level_of(16, {}), FallbackLevel::none) << engine;
  }
}

TEST(RecedingHorizonPlanner, HoldsWithoutIterationsToSpend) {
  for (const std::string& engine : engine_names()) {
    PlanningSettings settings;
    settings.engine = {.name = engine, .max_iterations = 1};
    RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, settings, testing::small_model());
    auto reports = quiet_reports(0, 5);
    reports[0].low_battery = reports[0].points = 3;
    const Plan plan = planner.plan(at(0), reports);
    EXPECT_EQ(plan.provenance.fallback, FallbackLevel::hold) << engine;
    EXPECT_TRUE(plan.moves.empty());
    EXPECT_NE(plan.provenance.reason.find("nominal: "), std::string::npos) << plan.provenance.reason;
  }
}

}  // namespace
}  // namespace evbal

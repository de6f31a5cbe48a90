#include "coordinator/planning/ladder.hpp"

#include <gtest/gtest.h>

#include <set>

namespace evbal {
namespace {

PlanningData with_vacant(double first) {
  PlanningData data;
  data.step_minutes = 30.0;
  data.state.vacant = Eigen::Vector2d(first, 0.0);
  data.state.low_battery = Eigen::Vector2d(0.0, 1.0);
  return data;
}

/// A balancer whose controllers fail on demand; its plans send two vehicles now and four in the next step.
struct Scripted {
  std::set<std::string> failing;

  BalancingResult operator()(const std::string& controller, const PlanningData&, const EngineSettings&) const {
    BalancingResult result;
    result.certificate.status = failing.contains(controller) ? SolveStatus::failed : SolveStatus::optimal;
    result.certificate.reason = result.certificate.optimal() ? "" : "iteration limit";
    if (result.certificate.optimal()) {
      result.certificate.objective = 5.0;
      result.dispatch.vacant = {{{0, 1, 2.0}}, {{0, 1, 4.0}}};
      result.dispatch.low_battery = {{{1, 0, 1.0}}, {}};
    }
    return result;
  }
};

TEST(Ladder, UsesTheControllerWhileItSolves) {
  Ladder ladder("robust", Scripted{});
  const Decision decision = ladder.decide(0, with_vacant(9), {});
  EXPECT_EQ(decision.provenance.fallback, FallbackLevel::none);
  EXPECT_EQ(decision.provenance.controller, "robust");
  EXPECT_EQ(decision.provenance.objective, 5.0);
  EXPECT_TRUE(decision.provenance.reason.empty());
  ASSERT_EQ(decision.vacant.size(), 1U);
  EXPECT_EQ(decision.vacant[0].amount, 2.0);
}

TEST(Ladder, FallsBackToNominal) {
  Ladder ladder("robust", Scripted{{"robust"}});
  const Decision decision = ladder.decide(0, with_vacant(9), {});
  EXPECT_EQ(decision.provenance.fallback, FallbackLevel::nominal);
  EXPECT_EQ(decision.provenance.reason, "robust: iteration limit");
  EXPECT_EQ(decision.vacant.size(), 1U);
}

TEST(Ladder, ThenToTheStepOfTheLastPlanThatCoversTheMinuteThenHolds) {
  Scripted script;
  Ladder ladder("nominal", [&script](const std::string& controller, const PlanningData& data,
                                     const EngineSettings& engine) { return script(controller, data, engine); });
  EXPECT_EQ(ladder.decide(10, with_vacant(9), {}).provenance.fallback, FallbackLevel::none);
  script.failing = {"nominal"};
  const Decision sent_already = ladder.decide(39, with_vacant(3), {});
  EXPECT_EQ(sent_already.provenance.fallback, FallbackLevel::shifted);
  EXPECT_TRUE(sent_already.vacant.empty() && sent_already.low_battery.empty());
  const Decision shifted = ladder.decide(40, with_vacant(3), {});
  EXPECT_EQ(shifted.provenance.fallback, FallbackLevel::shifted);
  ASSERT_EQ(shifted.vacant.size(), 1U);
  EXPECT_EQ(shifted.vacant[0].amount, 3.0) << "no more than the region has";
  const Decision hold = ladder.decide(70, with_vacant(3), {});
  EXPECT_EQ(hold.provenance.fallback, FallbackLevel::hold);
  EXPECT_TRUE(hold.vacant.empty() && hold.low_battery.empty());
  EXPECT_NE(hold.provenance.reason.find("in a row: 3"), std::string::npos) << hold.provenance.reason;
  script.failing.clear();
  EXPECT_EQ(ladder.decide(80, with_vacant(9), {}).provenance.fallback, FallbackLevel::none);
}

TEST(Ladder, HoldsWhereNothingWasEverSolved) {
  Ladder ladder("robust", Scripted{{"robust", "nominal"}});
  const Decision decision = ladder.decide(0, with_vacant(9), {});
  EXPECT_EQ(decision.provenance.fallback, FallbackLevel::hold);
  EXPECT_EQ(decision.provenance.reason, "robust: iteration limit; nominal: iteration limit; failures in a row: 1");
}

}  // namespace
}  // namespace evbal

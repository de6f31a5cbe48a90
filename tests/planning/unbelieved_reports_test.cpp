#include "agents/protocol/bytes.hpp"
#include "common/error.hpp"
#include "common/random.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "coordinator/planning/receding_horizon_planner.hpp"
#include "tests/planning/planner_fixture.hpp"
#include "tests/planning/small_city.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <map>
#include <set>

namespace evbal {
namespace {

using testing::at;
using testing::quiet_reports;
using testing::Spy;

using Reasons = std::vector<std::pair<int, std::string>>;

Reasons reasons(const Plan& plan) {
  Reasons all;
  for (const Rejection& rejection : plan.provenance.rejected) {
    all.emplace_back(rejection.region, rejection.reason);
  }
  return all;
}

TEST(RecedingHorizonPlanner, SaysWhichReportsItDoesNotBelieve) {
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, testing::small_model(), Spy{});
  EXPECT_EQ(reasons(planner.plan(at(0), quiet_reports(0, 5))), Reasons{});
  auto reports = quiet_reports(2, 5);
  reports.pop_back();
  reports[0].vacant = -3;
  EXPECT_EQ(reasons(planner.plan(at(2), reports)), (Reasons{{0, "vacant -3"}, {2, "is missing"}}));
  reports = quiet_reports(4, 5);
  reports[2].region = 7;
  reports[1].tick = 2;
  EXPECT_EQ(reasons(planner.plan(at(4), reports)),
            (Reasons{{1, "is of tick 2"}, {2, "is missing"}, {7, "is no region of this city"}}));
}

TEST(RecedingHorizonPlanner, EstimatesWhatItDoesNotBelieve) {
  const Spy spy;
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, testing::small_model(), spy);
  planner.plan(at(0), quiet_reports(0, 12));
  const double usual_deviation = spy.seen->demand.deviation(1);
  double deviation = usual_deviation;
  for (int tick = 2; tick <= 6; tick += 2) {
    auto reports = quiet_reports(tick, 12);
    reports[0].demand = reports[2].demand = tick == 2 ? 2 : 1;
    reports[1].vacant = 1 << 30;
    reports[1].demand = 1 << 30;
    planner.plan(at(tick), reports);
    EXPECT_LT(spy.seen->state.vacant(1), 12.0) << "some have left with passengers";
    EXPECT_GT(spy.seen->state.vacant(1), 4.0);
    EXPECT_EQ(spy.seen->state.vacant(0), 12.0);
    EXPECT_GT(spy.seen->demand.deviation(1), deviation) << "the longer, the less is known";
    EXPECT_NEAR(spy.seen->demand.mean(1), 4.0, 1.0);
    deviation = spy.seen->demand.deviation(1);
  }
  planner.plan(at(8), quiet_reports(8, 12));
  EXPECT_EQ(spy.seen->state.vacant(1), 12.0);
  EXPECT_EQ(spy.seen->demand.deviation(1), usual_deviation);
}

TEST(RecedingHorizonPlanner, LearnsNothingFromReportsItDoesNotBelieve) {
  const Spy spy;
  const CityModel model = testing::small_model();
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, model, spy);
  SeasonalForecaster demand(model.demand.seasonal, DayKind::weekday);
  SeasonalForecaster completions(model.completions.seasonal, DayKind::weekday);
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  for (int tick = 0; tick <= 8; tick += 2) {
    auto reports = quiet_reports(tick, 12);
    reports[0].demand = tick == 0 ? 0 : 5;
    reports[2].demand = tick == 0 ? 0 : 3;
    reports[1].vacant = -1;
    reports[1].demand = reports[1].completions = 1;
    planner.plan(at(tick), reports);
    const int minute = 5 * tick;
    demand.observe(minute, Eigen::Vector3d(5.0, unknown, 3.0));
    completions.observe(minute, Eigen::Vector3d(0.0, unknown, 0.0));
    EXPECT_EQ(spy.seen->demand.mean, demand.forecast(minute, 2).reshaped()) << tick;
    EXPECT_EQ(spy.seen->completions.mean.head(2), completions.forecast(minute, 2).col(0).head(2)) << tick;
  }
}

}  // namespace
}  // namespace evbal

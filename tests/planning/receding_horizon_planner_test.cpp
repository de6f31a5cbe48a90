#include "coordinator/planning/receding_horizon_planner.hpp"

#include "agents/protocol/bytes.hpp"
#include "common/error.hpp"
#include "common/random.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "tests/planning/planner_fixture.hpp"
#include "tests/planning/small_city.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

namespace evbal {
namespace {

using testing::at;
using testing::quiet_reports;
using testing::Spy;

TEST(RecedingHorizonPlanner, BuildsTheProblemFromReportsAndModel) {
  const Spy spy;
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, testing::small_model(), spy);
  planner.plan(at(0), quiet_reports(0, 5));
  EXPECT_EQ(spy.seen->transitions.size(), 2U);
  EXPECT_EQ(spy.seen->state.vacant(2), 5.0);
  EXPECT_EQ(spy.seen->demand.mean.size(), 6);
  EXPECT_DOUBLE_EQ(spy.seen->demand.mean(0), 4.0);
  EXPECT_DOUBLE_EQ(spy.seen->completions.mean(1), 1.0);
  EXPECT_DOUBLE_EQ(spy.seen->completions.mean(2), 0.0) << "no points in the third region";
  EXPECT_LT(spy.seen->completions.standard_deviation()(2), 0.01);
  EXPECT_DOUBLE_EQ(spy.seen->demand.g2, 1.2);
}

TEST(RecedingHorizonPlanner, SeesSlotBySlotWhatBecomesVacant) {
  const Spy spy;
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, testing::small_model(), spy);
  auto reports = quiet_reports(0, 5);
  reports[2].bound = {{2, 15, Errand::rebalance, 2}};
  planner.plan(at(0), reports);
  ASSERT_EQ(spy.seen->freed.mean.cols(), 9);
  // Of 4 passengers a step in each region, a quarter of region 1's get out after 12 minutes, all of region 2's after 4.
  const double getting_out = 0.95 * 0.9 * (4.0 / 30.0) * (0.25 * 8.0 + 16.0);
  EXPECT_NEAR(spy.seen->freed.mean(2, 1), 2.0 + getting_out, 1e-9);
  EXPECT_NEAR(spy.seen->freed.variance(2, 1), getting_out, 1e-9);
}

TEST(RecedingHorizonPlanner, ForecastsFollowWhatIsReported) {
  const Spy spy;
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, testing::small_model(), spy);
  for (int tick = 0; tick <= 6; tick += 2) {
    auto reports = quiet_reports(tick, 5);
    for (Report& report : reports) {
      report.demand = tick == 0 ? 0 : 4;
    }
    planner.plan(at(tick), reports);
  }
  // 12 in half an hour against 4, everywhere; of an ARMA(1, 1) with 0.8 and -1/3, this share is left a step later.
  const double left = 0.8 - 1.0 / 3.0 / ((1.0 - 1.6 / 3.0 + 1.0 / 9.0) / (1.0 - 0.64));
  EXPECT_NEAR(spy.seen->demand.mean(0), 4.0 + left * 8.0, 1e-9);
  EXPECT_NEAR(spy.seen->completions.mean(0), 1.0 - left, 1e-9);
}

TEST(RecedingHorizonPlanner, ExpectsWhatItIsToldOfDemand) {
  const auto mean_under = [](const Effect& effect, int reported) {
    const Spy spy;
    RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, testing::small_model(), spy);
    for (int tick = 0; tick <= 6; tick += 2) {
      Tick announced = at(tick);
      announced.effects = {effect};
      auto reports = quiet_reports(tick, 5);
      for (Report& report : reports) {
        report.demand = report.region != effect.region ? 1 : tick == 0 ? 0 : reported;
      }
      planner.plan(announced, reports);
    }
    return spy.seen->demand.mean(effect.region);
  };
  const double usual = mean_under({.type = EffectType::charger_outage, .region = 1}, 4);
  EXPECT_NEAR(mean_under({.type = EffectType::demand_scale, .region = 1, .magnitude = 2.0}, 8), 2.0 * usual, 1e-9);
  EXPECT_NEAR(mean_under({.type = EffectType::demand_add, .region = 1, .magnitude = 36.0}, 10), usual + 18.0, 1e-9);
  EXPECT_EQ(mean_under({.type = EffectType::demand_scale, .region = 1, .magnitude = 2.0, .visible = false}, 8),
            mean_under({.type = EffectType::charger_outage, .region = 1}, 8));
}

/// Reports of what is usual in small_city(), every 10 minutes; `more` passengers in the second region.
std::vector<Report> usual_reports(int tick, int more) {
  auto reports = quiet_reports(tick, 5);
  for (Report& report : reports) {
    report.demand = tick == 0 ? 0 : (tick % 6 == 0 ? 2 : 1) + (report.region == 1 ? more : 0);
    report.completions = tick > 0 && tick % 6 == 0 && report.region < 2 ? 1 : 0;
  }
  return reports;
}

TEST(RecedingHorizonPlanner, InflatesTheSetWhereForecastsAreOff) {
  const Spy spy;
  PlanningSettings settings;
  settings.innovation_test = true;
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, settings, testing::small_model(), spy);
  RecedingHorizonPlanner untested(testing::small_city(), {}, testing::date, {}, testing::small_model(), Spy{spy});
  RecedingHorizonPlanner told(testing::small_city(), {}, testing::date, settings, testing::small_model(), Spy{});
  const auto at_day_start = [&] {
    planner.plan(at(0), usual_reports(0, 0));
    return spy.seen->demand.standard_deviation();
  }();
  double most = 1.0;
  for (int tick = 2; tick <= 60; tick += 2) {
    const int more = tick > 12 && tick <= 24 ? 12 : 0;
    const auto reports = usual_reports(tick, more);
    EXPECT_EQ(untested.plan(at(tick), reports).provenance.demand_widened, 1.0);
    EXPECT_EQ(spy.seen->demand.standard_deviation(), at_day_start);
    Tick announced = at(tick);
    if (tick > 10 && tick <= 22) {
      announced.effects = {{.type = EffectType::demand_add, .region = 1, .magnitude = 72.0}};
    }
    EXPECT_EQ(told.plan(announced, reports).provenance.demand_widened, 1.0) << "what is announced raises no alarm";
    const Provenance made = planner.plan(at(tick), reports).provenance;
    const Eigen::VectorXd factor = spy.seen->demand.standard_deviation().cwiseQuotient(at_day_start);
    EXPECT_NEAR(factor.maxCoeff(), made.demand_widened, 1e-12);
    EXPECT_NEAR(factor(1), factor(4), 1e-12) << "in every step";
    EXPECT_EQ(made.completions_widened, 1.0);
    most = std::max(most, made.demand_widened);
    if (tick <= 12 || tick > 50) {
      EXPECT_EQ(made.demand_widened, 1.0) << "before, and when it is over";
    }
  }
  EXPECT_GT(most, 3.0);
}

TEST(RecedingHorizonPlanner, CountsOnThePointsThatWork) {
  const Spy spy;
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, {}, testing::small_model(), spy);
  auto reports = quiet_reports(0, 5);
  reports[0].points = 2;
  reports[1].points = 1;
  planner.plan(at(0), reports);
  EXPECT_EQ(spy.seen->free_points.mean.head(3), Eigen::Vector3d(2.0, 1.0, 0.0));
  reports = quiet_reports(2, 5);
  reports[1].points = 1;
  planner.plan(at(2), reports);
  EXPECT_EQ(spy.seen->free_points.mean.head(3), Eigen::Vector3d(0.0, 1.0, 0.0)) << "an outage is reported";
  EXPECT_TRUE(spy.seen->points.row(0).isZero());
}

TEST(RecedingHorizonPlanner, ForeseesWhatItWasTold) {
  const Spy spy;
  const DayClock clock;
  RecedingHorizonPlanner planner(testing::small_city(), clock, testing::date, {}, testing::small_model(), spy);
  Eigen::MatrixXd demand = Eigen::MatrixXd::Zero(3, clock.ticks());
  demand.row(1).setLinSpaced(0.0, clock.ticks() - 1.0);
  planner.foresee(demand);
  planner.plan(at(2), quiet_reports(2, 5));
  EXPECT_DOUBLE_EQ(spy.seen->demand.mean(0), 0.0);
  EXPECT_DOUBLE_EQ(spy.seen->demand.mean(1), 2.0 + 3.0 + 4.0 + 5.0 + 6.0 + 7.0);
  EXPECT_DOUBLE_EQ(spy.seen->demand.mean(4), 8.0 + 9.0 + 10.0 + 11.0 + 12.0 + 13.0);
  EXPECT_LT(spy.seen->demand.standard_deviation().maxCoeff(), 0.01);
  const int last = clock.ticks() - 2;
  planner.plan(at(last), quiet_reports(last, 5));
  EXPECT_DOUBLE_EQ(spy.seen->demand.mean(1), last + last + 1.0) << "nothing after the day";
}

TEST(RecedingHorizonPlanner, AddsNoAnnouncementToWhatItForesees) {
  const Spy spy;
  const DayClock clock;
  RecedingHorizonPlanner planner(testing::small_city(), clock, testing::date, {}, testing::small_model(), spy);
  planner.foresee(Eigen::MatrixXd::Ones(3, clock.ticks()));
  Tick announced = at(0);
  announced.effects = {{.type = EffectType::demand_scale, .region = 1, .magnitude = 2.0}};
  planner.plan(announced, quiet_reports(0, 5));
  EXPECT_DOUBLE_EQ(spy.seen->demand.mean(1), 6.0) << "the true demand holds the fault already";
}

TEST(RecedingHorizonPlanner, TakesOverFromAnother) {
  int solves = 0;
  const Balancer fails_from_the_fourth_on = [&solves](const std::string&, const PlanningData& data, const auto&) {
    BalancingResult result;
    result.certificate.status = ++solves <= 3 ? SolveStatus::optimal : SolveStatus::failed;
    const auto& start = data.start.basic;
    result.certificate.objective = data.demand.mean.sum() + (start.empty() ? 0.0 : static_cast<double>(start.front()));
    result.start.basic = {static_cast<std::uint64_t>(100 * solves)};
    result.dispatch.vacant = {{{0, 1, 1.0 * solves}}, {{1, 2, 2.0}}, {{2, 0, 3.0}}};
    return result;
  };
  PlanningSettings settings;
  settings.controller = "nominal";
  settings.innovation_test = true;
  const auto made = [&] {
    return RecedingHorizonPlanner(testing::small_city(), {}, testing::date, settings, testing::small_model(),
                                  fails_from_the_fourth_on);
  };
  const auto reports = [](int tick) {
    auto list = quiet_reports(tick, 9);
    list[1].demand = tick;
    list.resize(tick < 4 ? 3 : 2);  // the third is estimated, from the plans too
    return list;
  };
  RecedingHorizonPlanner first = made();
  std::vector<std::string> plans;
  std::vector<std::string> memories;
  for (int tick = 0; tick < 12; tick += 2) {
    plans.push_back(to_bytes(first.plan(at(tick), reports(tick))));
    memories.push_back(first.memory());
  }
  for (std::size_t known = 0; known < plans.size(); ++known) {
    RecedingHorizonPlanner second = made();
    solves = static_cast<int>(known);
    for (std::size_t i = 0; i < plans.size(); ++i) {
      const int tick = 2 * static_cast<int>(i);
      if (i < known) {
        second.recall(at(tick), reports(tick), memories[i]);
      } else {
        EXPECT_EQ(to_bytes(second.plan(at(tick), reports(tick))), plans[i]) << known << " recalled, plan " << i;
      }
    }
  }
}

TEST(RecedingHorizonPlanner, RefusesAModelThatDoesNotFit) {
  City four = testing::small_city();
  four.regions.resize(4);
  four.km = four.minutes = Eigen::MatrixXd::Ones(4, 4);
  EXPECT_THROW(RecedingHorizonPlanner(four, {}, testing::date, {}, testing::small_model(), Spy{}), Error);
  PlanningSettings far;
  far.balancing.tau = 3;
  EXPECT_THROW(RecedingHorizonPlanner(testing::small_city(), {}, testing::date, far, testing::small_model(), Spy{}),
               Error);
  EXPECT_THROW(
      RecedingHorizonPlanner(testing::small_city(), {.step = 60}, testing::date, {}, testing::small_model(), Spy{}),
      Error);
}

void expect_misfit(const CityModel& model, const std::string& what) {
  try {
    RecedingHorizonPlanner(testing::small_city(), {}, testing::date, {}, model, Spy{});
    FAIL() << "was accepted, expected a refusal about " << what;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("evbal fit"), std::string::npos) << error.what();
  }
}

TEST(RecedingHorizonPlanner, RefusesAModelOfAnotherCity) {
  CityModel model = testing::small_model();
  model.city = "large";
  expect_misfit(model, "the model is of large, the city is small");
  model = testing::small_model();
  model.day_start = 6 * 60;
  expect_misfit(model, "the model's day starts at 06:00, the city's at 05:00");
  model = testing::small_model();
  for (SeriesModel* series : {&model.demand, &model.completions}) {
    for (Eigen::MatrixXd& mean : series->seasonal.mean) {
      mean = mean.leftCols(20).eval();
    }
  }
  expect_misfit(model, "the model's day has 20 steps, the city's 38");
}

TEST(RecedingHorizonPlanner, PlansByAControllerOfOnesOwn) {
  PlanningSettings settings;
  settings.controller = "mine";
  const Controller mine{"mine", [](const auto&, const PlanningData& data, const auto&) {
                          Dispatch dispatch{.vacant = {{{0, 2, data.state.vacant(0)}}}, .low_battery = {{}}};
                          return by_rule(dispatch);
                        }};
  RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, settings, testing::small_model(),
                                 balancer_of(settings, {mine}));
  const Plan plan = planner.plan(at(0), quiet_reports(0, 5));
  EXPECT_EQ(plan.provenance.controller, "mine");
  ASSERT_EQ(plan.moves.size(), 1U);
  EXPECT_EQ(plan.moves[0].to, 2);
  EXPECT_EQ(plan.moves[0].count, 5);
}

RC_GTEST_PROP(RecedingHorizonPlannerProperty, NeverSendsMoreThanARegionHas, (std::uint64_t seed)) {
  RandomStream random(seed, Purpose::fleet, {});
  City city = testing::small_city();
  city.charging.top_up = *rc::gen::arbitrary<bool>();
  for (const std::string& controller : controller_names()) {
    PlanningSettings settings;
    settings.controller = controller;
    settings.engine.name = "cuts";
    RecedingHorizonPlanner planner(city, {}, testing::date, settings, testing::small_model());
    auto reports = quiet_reports(0, 0);
    for (Report& report : reports) {
      report.vacant = static_cast<int>(random.below(20));
      report.chargeable = static_cast<int>(random.below(static_cast<std::uint64_t>(report.vacant) + 1));
      report.low_battery = static_cast<int>(random.below(5));
      for (int car = 0; car < report.low_battery; ++car) {
        report.reach_m.push_back(3000 * car);
      }
      report.points = static_cast<int>(random.below(3));
      report.plugged = static_cast<int>(random.below(static_cast<std::uint64_t>(report.points) + 1));
      report.bound = {{report.region, 7, Errand::passenger, static_cast<int>(random.below(4))}};
    }
    const Plan plan = planner.plan(at(0), reports);
    RC_ASSERT(plan.provenance.fallback == FallbackLevel::none);
    std::map<std::pair<Errand, int>, int> sent;
    std::map<int, int> topped_up;
    for (std::size_t m = 0; m < plan.moves.size(); ++m) {
      const Move& move = plan.moves[m];
      const bool stays = move.from == move.to;
      RC_ASSERT(move.count >= 1);
      RC_ASSERT(!stays || (city.charging.top_up && move.errand == Errand::charge));
      sent[{stays ? Errand::rebalance : move.errand, move.from}] += move.count;
      topped_up[move.from] += stays ? move.count : 0;
      if (m > 0) {
        const Move& before = plan.moves[m - 1];
        RC_ASSERT(std::tie(before.errand, before.from, before.to) < std::tie(move.errand, move.from, move.to));
      }
    }
    for (const Report& report : reports) {
      const int vacant = sent[{Errand::rebalance, report.region}];
      const int low_battery = sent[{Errand::charge, report.region}];
      RC_ASSERT(vacant <= report.vacant && low_battery <= report.low_battery);
      RC_ASSERT(topped_up[report.region] <=
                std::min(report.chargeable, std::max(0, report.points - report.plugged - report.low_battery)));
    }
  }
}

}  // namespace
}  // namespace evbal

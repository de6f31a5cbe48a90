#include "agents/world/draws.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "coordinator/planning/receding_horizon_planner.hpp"
#include "experiments/bound/bound_front.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"
#include "experiments/run/record_day.hpp"
#include "experiments/scenario/scenario.hpp"
#include "tests/support/source_folder.hpp"
#include "tests/support/worlds.hpp"
#include "tools/fit/trip_shares.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

const std::vector<double> prices = {0.5, 3.0, 30.0};

/// The bound at these prices, without what is none.
DayBound bound_of(const World& world, const std::vector<Faults>& faults) {
  const auto but_up = [](const BoundProgress& progress) { return progress.rounding == Rounding::up; };
  return day_bound(bound_day(world, [&](int tick) { return faults[tick]; }), prices, but_up);
}

/// What a played day came to, all km without passengers counted.
Driving came_to(const World& world, const InprocPlayers::Planner& planner, const std::vector<Faults>& faults) {
  InprocPlayers players(world, planner, [&](int tick) { return faults[tick]; });
  Driving driving;
  run_day(world, players, [&](const TickRecord& record) {
    for (const Departures& said : record.exchange.departures) {
      for (const Departure& departure : said.departures) {
        driving.km += departure.errand == Errand::passenger ? 0.0 : departure.km;
      }
      driving.lost += static_cast<double>(
          std::count_if(said.fates.begin(), said.fates.end(), [](const Fate& fate) { return !fate.served; }));
    }
  });
  return driving;
}

bool is_above(const Driving& played, const DayBound& bound) {
  return played.lost >= bound.capacity.lost && std::ranges::all_of(bound.points, [&](const BoundPoint& point) {
           return point.price * played.lost + played.km >= point.bound - 1e-6;
         });
}

/// Up to six faults as schedules allow them: nobody drives faster than the records say.
std::vector<Faults> some_faults(const World& world) {
  auto faults = *test::faults_for(world);
  for (Faults& of_tick : faults) {
    for (Effect& effect : of_tick.effects) {
      effect.magnitude = std::max(effect.type == EffectType::travel_slow ? 1.0 : 0.0, effect.magnitude);
    }
  }
  return faults;
}

/// To whoever waits most come all cars of the regions that have more than they need.
Plan chase(int tick, const std::vector<Report>& reports) {
  Plan plan;
  plan.tick = tick;
  const auto needy = std::max_element(reports.begin(), reports.end(), [](const Report& a, const Report& b) {
    return a.waiting - a.vacant < b.waiting - b.vacant;
  });
  for (const Report& report : reports) {
    const int spare = report.vacant - report.waiting;
    if (needy->waiting > needy->vacant && report.region != needy->region && spare > 0) {
      plan.moves.push_back({.from = report.region, .to = needy->region, .count = spare, .errand = Errand::rebalance});
    }
  }
  return plan;
}

/// A series whose forecasts are `means` (N x steps) on any day, and hardly wrong.
SeriesModel series_of(const Eigen::MatrixXd& means) {
  constexpr int leads = 2;
  const Eigen::Index n = means.rows();
  SeriesModel series;
  series.seasonal.mean.fill(means);
  series.seasonal.region.resize(static_cast<std::size_t>(n));
  series.errors.covariance.deviation = Eigen::VectorXd::Constant(n * leads, 0.5);
  series.errors.covariance.factors = Eigen::MatrixXd::Zero(n * leads, 0);
  series.errors.thresholds.assign(leads, {0.1, 1.2});
  return series;
}

/// Knows the day that is played, as far as a model can: the better the plans are, the more a bound has to hold.
CityModel model_of_the_day(const World& world) {
  const City& city = world.city;
  const int n = city.size();
  Eigen::MatrixXd appear = Eigen::MatrixXd::Zero(n, city.steps_per_day());
  for (std::size_t step = 0; step < world.day.steps.size(); ++step) {
    for (const TripCount& count : world.day.steps[step]) {
      appear(count.origin, static_cast<Eigen::Index>(step)) += count.trips;
    }
  }
  CityModel model;
  model.city = city.name;
  model.day_start = city.day_start;
  model.step_minutes = city.step_minutes;
  model.demand = series_of(appear);
  model.completions = series_of(Eigen::MatrixXd::Constant(n, city.steps_per_day(), 1.0));
  const Eigen::MatrixXd stay = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd spread = Eigen::MatrixXd::Constant(n, n, 0.4 / n);
  model.periods = {{city.day_start, {0.5 * stay, spread, 0.1 * stay, stay, Eigen::MatrixXd::Zero(n, n)}}};
  model.trips = trip_shares(city, {world.day});
  model.turnover = {.demand = {.linear = {1.2}, .quadratic = {0.0}},
                    .phi = 0.5,
                    .same_step_dropoffs = Eigen::MatrixXd::Constant(n, n, 0.3 / n)};
  model.mean_session_minutes = 27.0;
  return model;
}

/// The day under a controller of evbal.
Driving came_to(const World& world, const std::string& controller, const std::vector<Faults>& faults) {
  PlanningSettings settings;
  settings.controller = controller;
  settings.engine.name = "cuts";
  RecedingHorizonPlanner planner(world.city, world.clock, world.day.date, settings, model_of_the_day(world));
  if (foresees(controller)) {
    planner.foresee(demand_by_tick(world, [&](int tick) { return faults[tick].effects; }));
  }
  return came_to(
      world, [&](const Tick& tick, const auto& reports) { return planner.plan(tick, reports); }, faults);
}

// Whoever plays, whatever goes wrong: no day lies below the bound.
RC_GTEST_PROP(DayBound, IsNeverBeaten, ()) {
  const World world = *test::small_worlds();
  const std::vector<Faults> faults = some_faults(world);
  const DayBound bound = bound_of(world, faults);
  const std::vector<InprocPlayers::Planner> planners = {
      [](const Tick& tick, const auto&) { return test::hold(tick.tick); },
      [](const Tick& tick, const auto& reports) { return test::wander(1, tick.tick, reports); },
      [](const Tick& tick, const auto& reports) { return chase(tick.tick, reports); }};
  for (const auto& planner : planners) {
    RC_ASSERT(is_above(came_to(world, planner, faults), bound));
  }
}

RC_GTEST_PROP(DayBound, IsBelowEveryController, ()) {
  World world = *test::small_worlds();
  world.clock.plan_every = std::max(world.clock.tick, 10);
  const std::string controller = *rc::gen::elementOf(controller_names());
  const std::vector<Faults> faults = some_faults(world);
  const DayBound bound = bound_of(world, faults);
  for (const bool top_up : {false, true}) {
    world.city.charging.top_up = top_up;
    RC_ASSERT(is_above(came_to(world, controller, faults), bound));
  }
}

TEST(DayBound, IsBelowEveryControllerOnTheToyCity) {
  Overrides overrides;
  overrides.settings = {"clock={start: \"07:00\", end: \"10:00\", tick: 5min, step: 30min, plan_every: 10min}",
                        "faults={schema: 1, seed: 1, faults: [{name: spike, type: demand.scale, target: {regions: "
                        "[1, 4]}, start: \"08:00\", duration: 90min, magnitude: 1.8}]}",
                        "transport=inproc"};
  Scenario scenario = read_scenario(test::in_source("experiments/scenarios/toy.yaml"), overrides);
  const DayBound bound = day_bound(bound_day(scenario), prices, [](const BoundProgress&) { return false; });
  EXPECT_GT(bound.points.back().bound, 1.0);
  for (const bool top_up : {false, true}) {
    scenario.world.city.charging.top_up = top_up;
    for (const std::string& controller : controller_names()) {
      const Totals totals = play_day(with_controller(scenario, controller)).metrics.totals;
      const Driving played{totals.flows.rebalance_km + totals.flows.charge_km, static_cast<double>(totals.flows.lost)};
      EXPECT_TRUE(is_above(played, bound)) << controller << (top_up ? ", top-up" : "");
      EXPECT_GE(played.lost, fewest_lost(bound, played.km)) << controller << (top_up ? ", top-up" : "");
    }
  }
}

}  // namespace
}  // namespace evbal

#pragma once

#include "agents/protocol/fingerprint.hpp"
#include "coordinator/planning/receding_horizon_planner.hpp"
#include "experiments/conductor/dds_players.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"
#include "experiments/scenario/scenario.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace evbal::test {

/// A series that forecasts `mean` everywhere.
inline SeriesModel flat_series(int regions, double mean, int leads) {
  SeriesModel series;
  series.seasonal.mean.fill(Eigen::MatrixXd::Constant(regions, 38, mean));
  series.seasonal.region.resize(static_cast<std::size_t>(regions));
  series.errors.covariance.deviation = Eigen::VectorXd::LinSpaced(regions * leads, 0.5, 1.5);
  series.errors.covariance.factors = Eigen::MatrixXd::Constant(regions * leads, 1, 0.3);
  series.errors.thresholds.assign(static_cast<std::size_t>(leads), {0.1, 1.2});
  return series;
}

/// Knows nothing of the city, which is enough to plan something.
inline CityModel rough_model(const City& city) {
  const int n = city.size();
  const Eigen::MatrixXd stay = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd spread = Eigen::MatrixXd::Constant(n, n, 0.4 / n);
  CityModel model;
  model.city = city.name;
  model.day_start = city.day_start;
  model.demand = flat_series(n, 8.0, 4);
  model.completions = flat_series(n, 1.0, 4);
  model.periods = {{city.day_start, {0.5 * stay, spread, 0.1 * stay, stay, Eigen::MatrixXd::Zero(n, n)}}};
  model.trips = {{city.day_start, {}}};
  for (int i = 0; i < n; ++i) {
    model.trips.front().shares.push_back({i, i, 1.0});
  }
  model.turnover = {.demand = {.linear = {1.4}, .quadratic = {0.0}},
                    .phi = 0.5,
                    .same_step_dropoffs = Eigen::MatrixXd::Constant(n, n, 0.1)};
  model.mean_session_minutes = 45.0;
  return model;
}

/// The toy scenario, planned by `robust` with a model that the test makes.
class ToyDay : public testing::Test {
 protected:
  ToyDay() : scenario_(read_scenario(EVBAL_SOURCE_DIR "/experiments/scenarios/toy.yaml")) {
    scenario_.planning.controller = "robust";
    scenario_.planning.model = folder_.path() / "model.json";
    model_ = rough_model(scenario_.world.city);
    write_model(model_, scenario_.planning.model);
    write_scenario();
  }

  /// Plays the day's first six hours, with the fault in them.
  void end_at_eleven() {
    scenario_.world.clock.end = 11 * 60;
    scenario_.schedule.faults.resize(1);  // the other comes later
    write_scenario();
  }

  /// To be called once `scenario_` is changed.
  void write_scenario() const {
    folder_.write("scenario.resolved.yaml", resolved_yaml(scenario_, scenario_.planning.controller));
  }

  using Observer = std::function<void(const TickRecord&)>;

  std::string digest_of(
      Players& players, const Observer& observe = [](const TickRecord&) {},
      const std::function<void(int tick)>& before_tick = [](int) {}) {
    Digest digest;
    const auto gather = [&](const TickRecord& record) {
      fingerprint(digest, record.faults);
      for (const auto& report : record.exchange.reports) {
        fingerprint(digest, report);
        writers_.insert(report.origin.process_id);
      }
      if (record.exchange.plan) {
        fingerprint(digest, *record.exchange.plan);
        writers_.insert(record.exchange.plan->origin.process_id);
      }
      for (const auto& departures : record.exchange.departures) {
        fingerprint(digest, departures);
      }
      observe(record);
    };
    run_day(scenario_.world, players, gather, before_tick);
    return digest.hex();
  }

  std::string digest_over_dds(
      int regions_per_process, const Observer& observe = [](const TickRecord&) {}) {
    DdsPlayers players({.folder = folder_.path(),
                        .regions = scenario_.world.city.size(),
                        .regions_per_process = regions_per_process,
                        .world = &scenario_.world,
                        .programs = EVBAL_PROGRAMS,
                        .hosts = hosts_});
    return digest_of(players, observe);
  }

  std::string digest_in_process(int regions_per_process = 1) {
    const World& world = scenario_.world;
    RecedingHorizonPlanner coordinator(world.city, world.clock, world.day.date, scenario_.planning, model_);
    InprocPlayers players(
        world, [&](const Tick& tick, const auto& reports) { return coordinator.plan(tick, reports); },
        [&](int tick) { return faults_at(scenario_.schedule, world.clock, tick); }, regions_per_process);
    return digest_of(players);
  }

  Folder folder_;
  Scenario scenario_;
  CityModel model_;
  std::vector<HostSpec> hosts_;
  std::set<std::int64_t> writers_;  ///< processes that made a report or a plan
};

}  // namespace evbal::test

#include "agents/protocol/fingerprint.hpp"
#include "coordinator/planning/coordinator.hpp"
#include "experiments/conductor/dds_players.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"
#include "experiments/scenario/scenario.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <set>

namespace evbal {
namespace {

/// A series that forecasts `mean` everywhere.
SeriesModel flat_series(int regions, double mean, int leads) {
  SeriesModel series;
  series.seasonal.mean.fill(Eigen::MatrixXd::Constant(regions, 38, mean));
  series.seasonal.own = Eigen::MatrixXd::Constant(seasonal_lags, leads, 0.1);
  series.seasonal.city = Eigen::MatrixXd::Constant(seasonal_lags, leads, 0.1);
  series.errors.covariance.deviation = Eigen::VectorXd::LinSpaced(regions * leads, 0.5, 1.5);
  series.errors.covariance.factors = Eigen::MatrixXd::Constant(regions * leads, 1, 0.3);
  series.errors.thresholds.assign(static_cast<std::size_t>(leads), {0.1, 1.2});
  return series;
}

/// Knows nothing of the city, which is enough to plan something.
CityModel rough_model(const City& city) {
  const int n = city.size();
  const Eigen::MatrixXd stay = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd spread = Eigen::MatrixXd::Constant(n, n, 0.4 / n);
  CityModel model;
  model.city = city.name;
  model.day_start = city.day_start;
  model.demand = flat_series(n, 8.0, 4);
  model.completions = flat_series(n, 1.0, 4);
  model.periods = {{city.day_start, {0.5 * stay, spread, 0.1 * stay, stay, Eigen::MatrixXd::Zero(n, n)}}};
  model.mean_session_minutes = 45.0;
  return model;
}

/// The toy scenario, planned by `robust` with a model that the test makes.
class RealProcessesTest : public testing::Test {
 protected:
  RealProcessesTest() : scenario_(read_scenario(EVBAL_SOURCE_DIR "/experiments/scenarios/toy.yaml")) {
    scenario_.planning.controller = "robust";
    scenario_.planning.model = folder_.path() / "model.json";
    model_ = rough_model(scenario_.world.city);
    write_model(model_, scenario_.planning.model);
    folder_.write("scenario.resolved.yaml", resolved_yaml(scenario_, "robust"));
  }

  std::string digest_of(Players& players) {
    Digest digest;
    run_day(scenario_.world, players, [&](const TickRecord& record) {
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
    });
    return digest.hex();
  }

  std::string digest_over_dds(int regions_per_process) {
    DdsPlayers players({.folder = folder_.path(),
                        .regions = scenario_.world.city.size(),
                        .regions_per_process = regions_per_process,
                        .programs = EVBAL_PROGRAMS});
    return digest_of(players);
  }

  std::string digest_in_process() {
    const World& world = scenario_.world;
    Coordinator coordinator(world.city, world.clock, world.day.date, scenario_.planning, model_);
    InprocPlayers players(
        world, [&](const Tick& tick, const auto& reports) { return coordinator.plan(tick, reports); },
        [&](int tick) { return faults_at(scenario_.schedule, world.clock, tick); });
    return digest_of(players);
  }

  Folder folder_;
  Scenario scenario_;
  CityModel model_;
  std::set<std::int64_t> writers_;  ///< processes that made a report or a plan
};

TEST_F(RealProcessesTest, LiveTheSameDayHoweverTheyAreSpread) {
  const std::string alone = digest_over_dds(1);
  EXPECT_EQ(writers_.size(), static_cast<std::size_t>(scenario_.world.city.size()) + 1);
  EXPECT_FALSE(writers_.contains(getpid()));
  EXPECT_EQ(digest_over_dds(2), alone);
  EXPECT_EQ(digest_in_process(), alone);
}

TEST_F(RealProcessesTest, SayWhatIsWrongWithTheirInput) {
  std::ofstream(folder_.path() / "scenario.resolved.yaml", std::ios::app) << "city: twice\n";
  try {
    digest_over_dds(5);
    FAIL() << "a broken scenario was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("status 2"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("`city` is given twice"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace evbal

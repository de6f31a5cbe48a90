#include "tools/fit/training_day.hpp"

#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// As much of a model as `greedy` needs.
CityModel flat_model(const World& world) {
  const Eigen::Index n = world.city.size();
  CityModel model;
  model.city = world.city.name;
  model.day_start = world.city.day_start;
  model.mean_session_minutes = 30.0;
  for (SeriesModel* series : {&model.demand, &model.completions}) {
    series->seasonal.mean.fill(Eigen::MatrixXd::Constant(n, world.clock.steps(), 5.0));
    series->seasonal.region.resize(world.city.regions.size());
    series->errors.covariance = {Eigen::VectorXd::Ones(2 * n), Eigen::MatrixXd(2 * n, 0)};
    series->errors.thresholds.assign(2, {});
  }
  const TransitionCounts unseen(world.city.size());
  model.periods = {{0, transitions_of(unseen, unseen, 1.0)}};
  model.trips = {{0, {}}};
  model.turnover = {{{1.0}, {0.0}}, 0.0, Eigen::MatrixXd::Zero(n, n)};
  return model;
}

TEST(PeriodAt, IsTheLastThatHasBegun) {
  const std::vector<int> starts{300, 600};
  EXPECT_EQ(period_at(starts, 0), 0U);
  EXPECT_EQ(period_at(starts, 599), 0U);
  EXPECT_EQ(period_at(starts, 600), 1U);
}

TEST(TrainingDay, FollowsCarsThroughThePlantsDay) {
  World world;
  world.city = find_city(test::in_source("experiments/cities/toy-5").string());
  world.day = read_demand(world.city, "2024-01-03");
  const int vehicles = world.city.fleet.vehicles;
  PlanningSettings greedy;
  greedy.controller = "greedy";
  const TrainingDay day = play_training_day(world, flat_model(world), greedy, {5 * 60, 12 * 60});
  EXPECT_GT(day.served, 100);
  EXPECT_GT(day.idle_km, 100.0);
  EXPECT_GT(day.completions.sum(), 0.0);
  ASSERT_EQ(day.transitions.size(), 2U);
  const int origins_before_noon = 7 * 6;
  const int origins_after = (12 * 60 - 30) / 10;
  EXPECT_LE(day.transitions[0].vacant.sum() + day.transitions[0].occupied.sum(), vehicles * origins_before_noon);
  EXPECT_LE(day.transitions[1].vacant.sum() + day.transitions[1].occupied.sum(), vehicles * origins_after);
  EXPECT_GT(day.transitions[0].occupied.sum(), 0.0);
  EXPECT_GT(day.transitions[1].vacant.rightCols(5).sum(), 0.0) << "some run low";
}

}  // namespace
}  // namespace evbal

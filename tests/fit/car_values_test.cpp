#include "tools/fit/car_values.hpp"

#include "coordinator/balancing/arcs.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace evbal {
namespace {

// Far more passengers than cars in region 0, who all get out there one step later; region 1 is a step and 3 km away.
TEST(CarValues, AreThePassengersToComeLessTheWay) {
  City city;
  city.regions.resize(2);
  city.fleet.vehicles = 3;
  city.km = (Eigen::Matrix2d() << 7.0, 3.0, 3.0, 1.0).finished();
  city.minutes = (Eigen::Matrix2d() << 28.0, 30.0, 30.0, 28.0).finished();
  CityModel model;
  model.day_start = 22 * 60;
  model.demand.seasonal.mean.fill((Eigen::Matrix<double, 2, 4>() << 200, 200, 200, 200, 0, 0, 0, 0).finished());
  model.completions.seasonal.mean.fill(Eigen::Matrix<double, 2, 4>::Zero());
  model.trips = {{0, {{0, 0, 1.0}, {1, 1, 1.0}}}};
  const Eigen::MatrixXd values = car_values(city, model, DayKind::weekday);
  const Eigen::Matrix<double, 2, 4> expected =
      (Eigen::Matrix<double, 2, 4>() << 28, 21, 14, 7, 18, 11, 4, 0).finished();
  EXPECT_LT((values - expected).cwiseAbs().maxCoeff(), 2e-3) << values;
}

// Nobody gains by waiting or driving: otherwise the day would not be the best.
TEST(CarValues, LeaveNothingToBeGained) {
  const City city = read_city(test::in_source("experiments/cities/toy-5"));
  CityModel model = read_model(test::in_source("experiments/cities/toy-5/model.json"));
  for (int kind = 0; kind < day_kinds; ++kind) {
    const Eigen::MatrixXd values = car_values(city, model, static_cast<DayKind>(kind));
    EXPECT_GE(values.minCoeff(), 0.0);
    EXPECT_GT(values(0, 0), values.mean());
    model.car_values.at(static_cast<std::size_t>(kind)) = values;
    const auto value = [&](int region, double step) {
      return model.car_value(static_cast<DayKind>(kind), region, model.day_start + model.step_minutes * step);
    };
    for (int k = 0; k < values.cols(); ++k) {
      for (const Arc& arc : vacant_arcs(city.km, std::numeric_limits<double>::infinity(), 12)) {
        EXPECT_GE(values(arc.from, k), value(arc.from, k + 1.0) - 2e-3);
        EXPECT_GE(values(arc.from, k), value(arc.to, k + city.minutes(arc.from, arc.to) / 30.0) - arc.km - 2e-3);
      }
    }
  }
}

}  // namespace
}  // namespace evbal

#include "coordinator/planning/car_worth.hpp"

#include "tests/planning/small_city.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

// Three slots of ten minutes from 06:30 on; a tenth comes out low on battery.
TEST(CarWorth, IsThatOfTheEndOfTheSlotsAndOfWhereTripsGo) {
  PlanningData data;
  data.km = testing::small_city().km;
  data.minutes = testing::small_city().minutes;
  data.transitions.assign(2, testing::simple_transitions());
  data.freed.mean = Eigen::MatrixXd::Zero(3, 3);
  CityModel model = testing::small_model();
  for (Eigen::MatrixXd& values : model.car_values) {
    values = Eigen::MatrixXd::Zero(3, 38);
  }
  model.car_values[0].col(4) << 10.0, 20.0, 40.0;  // 07:00
  model.car_values[0].col(5) << 10.0, 20.0, 10.0;
  const CarWorth worth = car_worth(data, model, DayKind::weekday, 6 * 60 + 30, {});
  EXPECT_TRUE(worth.vacant.isApprox(Eigen::Vector3d(10.0, 20.0, 40.0)));
  // Of trips from 0 half stay, half go to 1; from 1 a quarter goes to 2, two minutes and ten later.
  EXPECT_NEAR(worth.serving(0), 0.9 * (0.5 * 10.0 + 0.5 * 20.0), 1e-9);
  EXPECT_NEAR(worth.serving(1), 0.9 * (0.25 * 10.0 + 0.5 * 20.0 + 0.25 * (40.0 - 30.0 * 12.0 / 30.0)), 1e-9);
  EXPECT_EQ(car_worth(data, model, DayKind::sunday, 6 * 60 + 30, {}).vacant.sum(), 0.0);
  const CarWorth unknown = car_worth(data, testing::small_model(), DayKind::weekday, 6 * 60 + 30, {});
  EXPECT_EQ(unknown.vacant.size(), 0) << "a model without values";
  EXPECT_EQ(unknown.serving.size(), 0);
}

}  // namespace
}  // namespace evbal

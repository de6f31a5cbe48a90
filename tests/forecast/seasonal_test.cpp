#include "coordinator/forecast/seasonal.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "coordinator/forecast/seasonal_fit.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace evbal {
namespace {

constexpr int steps = 38;

/// Days whose level differs from day to day and stays for the whole day.
std::vector<CountDay> days_with_levels(int count, int regions, std::uint64_t seed) {
  RandomStream random(seed, Purpose::poisson_demand, {});
  std::vector<CountDay> days;
  for (int d = 0; d < count; ++d) {
    const double level = 1.0 + 0.3 * random.normal();
    CountDay day{DayKind::weekday, Eigen::MatrixXd(regions, steps)};
    for (int step = 0; step < steps; ++step) {
      for (int region = 0; region < regions; ++region) {
        const double mean = (10.0 + 5.0 * region + step) * std::max(0.2, level);
        day.counts(region, step) = static_cast<double>(random.poisson(mean));
      }
    }
    days.push_back(day);
  }
  return days;
}

SeasonalModel plain_model(const Eigen::MatrixXd& mean) {
  return {30, {mean, mean, mean}, {}, std::vector<ArmaModel>(static_cast<std::size_t>(mean.rows()))};
}

ArmaModel autoregression(double ar) {
  return {.ar = Eigen::VectorXd::Constant(1, ar), .ma = {}, .variance = 1.0};
}

TEST(DayKind, FollowsTheCalendar) {
  EXPECT_EQ(day_kind("2008-05-26", false), DayKind::weekday);
  EXPECT_EQ(day_kind("2008-05-26", true), DayKind::sunday);
  EXPECT_EQ(day_kind("2008-05-31", false), DayKind::saturday);
  EXPECT_EQ(day_kind("2008-06-01", false), DayKind::sunday);
  for (const char* wrong : {"", "2008-6-1", "2008-02-30", "2008/06/01", "20a8-06-01"}) {
    EXPECT_THROW(day_kind(wrong, false), Error) << wrong;
  }
}

TEST(WindowSum, SharesStepsByOverlap) {
  const Eigen::MatrixXd mean = (Eigen::MatrixXd(1, 3) << 3.0, 6.0, 9.0).finished();
  EXPECT_DOUBLE_EQ(window_sum(mean, 30, 0, 30)(0), 3.0);
  EXPECT_DOUBLE_EQ(window_sum(mean, 30, 10, 40)(0), 2.0 + 2.0);
  EXPECT_DOUBLE_EQ(window_sum(mean, 30, 80, 110)(0), 3.0);
  EXPECT_DOUBLE_EQ(window_sum(mean, 30, -30, 0)(0), 0.0);
}

TEST(SeasonalForecaster, WithoutCorrectionIsTheSeasonalMean) {
  Eigen::MatrixXd mean(2, steps);
  mean.row(0).setLinSpaced(1.0, 20.0);
  mean.row(1).setConstant(4.0);
  const SeasonalModel model = plain_model(mean);
  SeasonalForecaster forecaster(model, DayKind::weekday);
  forecaster.observe(30, Eigen::Vector2d(50.0, 0.0));
  EXPECT_TRUE(forecaster.forecast(30, 2).isApprox(mean.middleCols(1, 2)));
  EXPECT_DOUBLE_EQ(forecaster.forecast(steps * 30 - 30, 2)(1, 1), 0.0) << "nothing after the day's end";
}

TEST(SeasonalForecaster, CorrectsByWhatWasSeenInTheLastStep) {
  const Eigen::MatrixXd mean = Eigen::MatrixXd::Constant(2, steps, 6.0);
  SeasonalModel model = plain_model(mean);
  model.city = autoregression(0.5);
  SeasonalForecaster city(model, DayKind::weekday);
  model.city = {};
  model.region[0] = autoregression(0.5);
  SeasonalForecaster region(model, DayKind::weekday);
  for (int minute = 10; minute <= 40; minute += 10) {
    const Eigen::Vector2d counts(minute <= 10 ? 0.0 : 4.0, 2.0);
    city.observe(minute, counts);
    region.observe(minute, counts);
  }
  // 12 and 6 in the last half hour against 6 and 6 expected; 9 would have been the first one's share.
  EXPECT_NEAR(city.forecast(40, 2)(0, 0), 6.0 + 0.5 * 3.0, 1e-12);
  EXPECT_NEAR(city.forecast(40, 2)(1, 1), 6.0 + 0.25 * 3.0, 1e-12);
  EXPECT_NEAR(region.forecast(40, 2)(0, 0), 6.0 + 0.5 * 3.0, 1e-12);
  EXPECT_NEAR(region.forecast(40, 2)(0, 1), 6.0 + 0.25 * 3.0, 1e-12);
  EXPECT_NEAR(region.forecast(40, 2)(1, 0), 6.0, 1e-12);
}

TEST(SeasonalForecaster, WaitsForWhatIsNotReported) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  SeasonalModel model = plain_model(Eigen::MatrixXd::Constant(2, steps, 6.0));
  model.region[0] = autoregression(0.5);
  SeasonalForecaster forecaster(model, DayKind::weekday);
  forecaster.observe(30, Eigen::Vector2d(12.0, 6.0));
  const double seen = forecaster.forecast(30, 2)(0, 1);
  forecaster.observe(60, Eigen::Vector2d(unknown, 6.0));
  EXPECT_NEAR(forecaster.forecast(60, 1)(0, 0), seen, 1e-12);
  EXPECT_EQ(forecaster.forecast(60, 1)(0, 0), forecaster.forecast(60, 2)(0, 0));
  EXPECT_NEAR(forecaster.forecast(90, 1)(0, 0) - 6.0, (seen - 6.0) / 2.0, 1e-12) << "nothing at all was reported";
  forecaster.observe(80, Eigen::Vector2d(unknown, unknown));
  forecaster.observe(90, Eigen::Vector2d(8.0, 2.0));
  EXPECT_NEAR(forecaster.forecast(90, 1)(0, 0) - 6.0, (seen - 6.0) / 2.0, 1e-12) << "ten minutes are too few";
}

TEST(SeasonalForecaster, KnowsHowFarItMayBeOff) {
  SeasonalModel model = plain_model(Eigen::MatrixXd::Constant(4, steps, 6.0));
  model.city = autoregression(0.5);
  model.city.variance = 2.0;
  model.region.assign(4, autoregression(0.5));
  const auto ahead = SeasonalForecaster(model, DayKind::weekday).predict(0, 1);
  EXPECT_NEAR(ahead.variance(0, 0), (2.0 * 36.0 / 24.0 + 6.25) / 0.75, 1e-12);
  EXPECT_NEAR(ahead.city_variance(0), (2.0 * 24.0 + 4.0 * 6.25) / 0.75, 1e-12) << "what the city shares adds up";
}

TEST(SeasonalForecaster, NeverForecastsLessThanNothing) {
  SeasonalModel model = plain_model(Eigen::MatrixXd::Constant(2, steps, 6.0));
  model.region[0] = autoregression(0.99);
  SeasonalForecaster forecaster(model, DayKind::weekday);
  forecaster.observe(30, Eigen::Vector2d(0.0, 60.0));
  EXPECT_DOUBLE_EQ(forecaster.forecast(30, 1)(0, 0), 0.0);
}

TEST(SeasonalForecaster, SaysHowFarTheLastStepsWereOff) {
  SeasonalModel model = plain_model(Eigen::MatrixXd::Constant(2, steps, 6.0));
  model.region[0].variance = 4.0;
  SeasonalForecaster forecaster(model, DayKind::weekday);
  EXPECT_EQ(forecaster.normalised_innovation(0).region, Eigen::Vector2d::Zero()) << "nothing is known yet";
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  forecaster.observe(30, Eigen::Vector2d(16.0, 6.0));
  // 22 against 12; 11 and 11 would have been their shares, and 6.25 is the scale squared.
  EXPECT_NEAR(forecaster.normalised_innovation(30).city, 100.0 / 12.0, 1e-12);
  EXPECT_NEAR(forecaster.normalised_innovation(30).region(0), 25.0 / 6.25 / 4.0, 1e-12);
  EXPECT_NEAR(forecaster.normalised_innovation(30).region(1), 25.0 / 6.25, 1e-12)
      << "no less than a Poisson count's variance";
  forecaster.observe(60, Eigen::Vector2d(6.0, unknown));
  EXPECT_NEAR(forecaster.normalised_innovation(60).region(0), 0.5, 1e-12);
  EXPECT_NEAR(forecaster.normalised_innovation(60).region(1), 4.0, 1e-12) << "what is unknown does not count";
  forecaster.observe(90, Eigen::Vector2d(6.0, 6.0));
  forecaster.observe(120, Eigen::Vector2d(6.0, 6.0));
  EXPECT_EQ(forecaster.normalised_innovation(120).region, Eigen::Vector2d::Zero())
      << "an hour and a half later it is forgotten";
}

TEST(DailyAlarm, IsExceededOnceADay) {
  std::vector<HeldOutDay> days(2);
  days[0].normalised_innovation = Eigen::Vector3d(5.0, 1.0, 9.0);
  days[1].normalised_innovation = Eigen::Vector3d(2.0, 4.0, 3.0);
  EXPECT_EQ(daily_alarm(days), 4.0);
}

TEST(FitSeasonal, LearnsThatALevelStays) {
  const auto days = days_with_levels(14, 4, 1);
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(4, 2);
  Skill skill{zero, zero, zero};
  for (const auto& day : leave_one_day_out(days, 30, choose_orders(days), 2)) {
    EXPECT_EQ(day.residuals.rows(), 8);
    EXPECT_EQ(day.residuals.cols(), steps - 1);
    EXPECT_GT(day.normalised_innovation.minCoeff(), 0.5) << "the largest of a day";
    EXPECT_LT(day.normalised_innovation.maxCoeff(), 20.0);
    skill += day.skill;
  }
  EXPECT_LT(skill.forecast.sum(), 0.7 * skill.seasonal_mean.sum());
  EXPECT_LT(skill.forecast.sum(), 0.9 * skill.last_value.sum());
}

TEST(FitSeasonal, FallsBackToTheMeanWhereCountsAreFew) {
  std::vector<CountDay> days = days_with_levels(3, 2, 1);
  for (CountDay& day : days) {
    day.counts.row(0).setZero();
  }
  const SeasonalOrders orders = choose_orders(days);
  EXPECT_EQ(orders.thin, std::vector<int>{0});
  EXPECT_EQ(orders.region[0], ArmaOrder{});
  const SeasonalModel model = fit_seasonal(days, 30, orders);
  EXPECT_TRUE(SeasonalForecaster(model, DayKind::weekday).forecast(0, 2).row(0).isZero());
}

TEST(FitSeasonal, TakesDaysWithoutCounts) {
  const std::vector<CountDay> days(3, {DayKind::sunday, Eigen::MatrixXd::Zero(2, steps)});
  const SeasonalModel model = fit_seasonal(days, 30, choose_orders(days));
  EXPECT_TRUE(SeasonalForecaster(model, DayKind::sunday).forecast(0, 2).isZero());
}

}  // namespace
}  // namespace evbal

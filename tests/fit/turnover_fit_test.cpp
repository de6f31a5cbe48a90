#include "tools/fit/turnover_fit.hpp"

#include "common/random.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(SameStepDropoffs, AreTheShortTripsOfTheRecord) {
  const City city = read_city(test::in_source("experiments/cities/toy-5"));
  const std::vector<DemandDay> days{read_demand(city, "2024-01-03"), read_demand(city, "2024-01-06")};
  const Eigen::MatrixXd shares = same_step_dropoffs(city, days, 30);
  ASSERT_EQ(shares.rows(), 5);
  EXPECT_GE(shares.minCoeff(), 0.0);
  EXPECT_LT(shares.rowwise().sum().maxCoeff(), 1.0);
  EXPECT_GT(shares.sum(), 1.0);
  EXPECT_EQ(same_step_dropoffs(city, days, 1).sum(), 0.0) << "nothing ends within a minute";
}

/// Poisson counts around forecasts that are scattered by `spread` about the truth.
HeldOutDay day_of(double spread) {
  RandomStream random(7, Purpose::poisson_demand, {});
  HeldOutDay day;
  day.forecasts = Eigen::MatrixXd::NullaryExpr(20, 400, [&] { return random.uniform(0.5, 30.0); });
  day.counts = day.forecasts.unaryExpr([&](double m) {
    const double gamma = spread > 0.0 ? 1.0 + spread * (random.uniform() < 0.5 ? -1.0 : 1.0) : 1.0;
    return static_cast<double>(random.poisson(m * gamma));
  });
  return day;
}

TEST(CountVariance, IsThatOfTheErrors) {
  const CountVariance poisson = fit_count_variance({day_of(0.0)}, 2);
  ASSERT_EQ(poisson.linear.size(), 2U);
  EXPECT_NEAR(poisson.at(0, 10.0), 10.0, 0.5);
  EXPECT_NEAR(poisson.at(5, 20.0), 20.0, 1.0) << "the last lead's for all further ones";
  // Var = m + (0.3 m)^2
  const CountVariance wide = fit_count_variance({day_of(0.3)}, 2);
  EXPECT_NEAR(wide.at(1, 10.0), 10.0 + 9.0, 1.5);
  EXPECT_NEAR(wide.at(1, 25.0), 25.0 + 56.25, 6.0);
}

TEST(IntegralTransform, IsFlatUnderTheRightLawOnly) {
  const std::vector<HeldOutDay> days{day_of(0.0)};
  const CountVariance right{.linear = {1.0}, .quadratic = {0.0}};
  const Eigen::MatrixXd flat = integral_transform(days, right, 2);
  EXPECT_NEAR(flat.col(0).sum(), 1.0, 1e-12);
  EXPECT_LT((flat.array() - 0.1).abs().maxCoeff(), 0.015);
  const CountVariance wide{.linear = {3.0}, .quadratic = {0.0}};
  EXPECT_LT(integral_transform(days, wide, 2)(0, 0), 0.05) << "too few counts far out";
}

}  // namespace
}  // namespace evbal

#include "coordinator/filter/stock_filter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

constexpr double of_a_report = 1e-4;

/// The textbook's equations.
struct Textbook {
  StockVector mean;
  StockMatrix covariance;

  void predict(const StockVector& change, const StockMatrix& noise) {
    mean += change;
    covariance += noise;
  }

  void observe(const Eigen::Matrix<double, 1, stocks>& of, double count, double variance) {
    const double total = of * covariance * of.transpose() + variance;
    const StockVector gain = covariance * of.transpose() / total;
    mean += gain * (count - of * mean);
    covariance -= gain * of * covariance;
  }
};

StockVector any_vector(int low, int high) {
  StockVector out;
  for (double& value : out) {
    value = *rc::gen::inRange(low, high) / 10.0;
  }
  return out;
}

RC_GTEST_PROP(StockFilter, FollowsTheTextbook, ()) {
  const StockVector start = any_vector(0, 200);
  const StockVector variances = any_vector(0, 50);
  StockFilter filter(start, variances);
  Textbook book{start, variances.asDiagonal()};
  for (int step = 0; step < 4; ++step) {
    const StockVector change = any_vector(-30, 30);
    const StockVector root = any_vector(-20, 20);
    const StockMatrix noise = root * root.transpose() + 0.1 * StockMatrix::Identity();
    filter.predict(change, noise);
    book.predict(change, noise);
    std::array<std::optional<double>, stocks> seen;
    for (int row = 0; row < stocks; ++row) {
      if (*rc::gen::arbitrary<bool>()) {
        seen.at(static_cast<std::size_t>(row)) = *rc::gen::inRange(0, 20);
        book.observe(Eigen::Matrix<double, 1, stocks>::Unit(row), *seen.at(static_cast<std::size_t>(row)), of_a_report);
      }
    }
    filter.observe(seen);
    const double variance = *rc::gen::inRange(0, 50) / 10.0;
    filter.observe_total(17.0, variance);
    book.observe({1.0, 0.0, 1.0, 1.0}, 17.0, variance + of_a_report);
    RC_ASSERT((filter.counts() - book.mean).norm() < 1e-6);
    RC_ASSERT((filter.covariance() - book.covariance).norm() < 1e-6);
  }
}

TEST(StockFilter, TakesTheOneUnknownCountFromTheTotal) {
  StockFilter filter({3.0, 2.0, 1.0, 4.0}, {25.0, 0.0, 0.0, 0.0});
  filter.observe_total(13.0, 0.0);
  EXPECT_NEAR(filter.counts()(0), 8.0, 1e-4);
  EXPECT_NEAR(filter.counts()(1), 2.0, 1e-9);
  EXPECT_NEAR(total(filter.counts()), 13.0, 1e-4);
  EXPECT_NEAR(total_variance(filter.covariance()), 0.0, 1e-3);
}

}  // namespace
}  // namespace evbal

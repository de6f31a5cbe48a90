#include "coordinator/forecast/arma.hpp"

#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace evbal {
namespace {

using nlohmann::json;

Eigen::VectorXd vector_of(const json& list) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    const json& item = list[static_cast<std::size_t>(i)];
    out(i) = item.is_null() ? std::numeric_limits<double>::quiet_NaN() : item.get<double>();
  }
  return out;
}

ArmaOrder order_of(const json& r) {
  return {r["p"], r["q"]};
}

std::vector<Eigen::VectorXd> stretches_of(const json& r) {
  std::vector<Eigen::VectorXd> out;
  for (const json& stretch : r["stretches"]) {
    out.push_back(vector_of(stretch));
  }
  return out;
}

/// Series, and what R's `arima` says of them (arma/make-fixtures.R).
json fixtures() {
  std::ifstream in(test::in_source("tests/forecast/arma/fixtures.json"));
  return json::parse(in);
}

bool near(const Eigen::VectorXd& ours, const json& theirs, double tolerance) {
  const Eigen::VectorXd expected = vector_of(theirs);
  return ours.size() == expected.size() && ((ours - expected).array().abs() < tolerance).all();
}

TEST(Arma, FindsTheMaximumThatRFinds) {
  for (const json& r : fixtures()) {
    SCOPED_TRACE(r["name"]);
    const ArmaFit fit = fit_arma(stretches_of(r), order_of(r));
    const double log_likelihood = r["log_likelihood"];
    EXPECT_NEAR(fit.log_likelihood, log_likelihood, 1e-6 * std::abs(log_likelihood));
    EXPECT_TRUE(near(fit.model.ar, r["ar"], 1e-3)) << fit.model.ar.transpose();
    EXPECT_TRUE(near(fit.model.ma, r["ma"], 1e-3)) << fit.model.ma.transpose();
    EXPECT_NEAR(fit.model.variance, r["variance"], 1e-3 * fit.model.variance);
  }
}

TEST(Arma, LooksAheadAsRDoes) {
  for (const json& r : fixtures()) {
    SCOPED_TRACE(r["name"]);
    const ArmaModel model{.ar = vector_of(r["ar"]), .ma = vector_of(r["ma"]), .variance = r["variance"]};
    ArmaFilter filter(model);
    const auto stretches = stretches_of(r);
    for (const double y : stretches.back()) {
      const Outlook expected = filter.outlook(1);
      const Innovation off = filter.observe(y);
      EXPECT_EQ(std::isnan(off.value), std::isnan(y));
      EXPECT_TRUE(std::isnan(y) || off.value == y - expected.mean(0));
      EXPECT_EQ(off.variance, expected.variance(0));
    }
    const Outlook outlook = filter.outlook(static_cast<int>(r["mean_ahead"].size()));
    EXPECT_TRUE(near(outlook.mean, r["mean_ahead"], 1e-5)) << outlook.mean.transpose();
    EXPECT_TRUE(near(outlook.variance.cwiseSqrt(), r["deviation_ahead"], 1e-5)) << outlook.variance.transpose();
  }
}

TEST(Arma, ChoosesTheOrderOfLeastAicc) {
  const json all = fixtures();
  const auto arma = std::find_if(all.begin(), all.end(), [](const json& r) { return r["name"] == "arma11"; });
  const ArmaFit chosen = choose_arma(stretches_of(*arma), {{}, {.p = 1}, {.q = 1}, {.p = 1, .q = 1}});
  EXPECT_EQ(chosen.model.order(), (ArmaOrder{.p = 1, .q = 1}));
  // R: AIC 1684.5282 of three parameters and 400 observations.
  EXPECT_NEAR(chosen.aicc(), 2.0 * 839.264085 + 6.0 + 24.0 / 396.0, 1e-3);
}

}  // namespace
}  // namespace evbal

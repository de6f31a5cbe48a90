#include "experiments/study/statistics/fault_influence.hpp"

#include "experiments/study/executors/drawn_quantities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace evbal {
namespace {

const std::vector<double> lost_by_draw = {106, 86, 100, 101, 99, 103, 97, 113, 112, 110};

TEST(FaultInfluence, IsARankCorrelationWithItsInterval) {
  // The example of Spearman's correlation in textbooks: rho = -29/165.
  const auto found = influences({{"jam", "minutes", {7, 0, 27, 50, 28, 29, 20, 12, 6, 17}}}, lost_by_draw);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].draws, 10);
  EXPECT_NEAR(found[0].correlation.mean, -29.0 / 165.0, 1e-12);
  // tanh(atanh(rho) -+ 1.959964 sqrt((1 + rho^2 / 2) / 7))
  EXPECT_NEAR(found[0].correlation.low, -0.72783, 1e-5);
  EXPECT_NEAR(found[0].correlation.high, 0.51455, 1e-5);
  EXPECT_NEAR(found[0].p, 0.631, 0.02);  // of 200,000 random orders
}

TEST(FaultInfluence, TellsTheFaultThatDidItFromThoseThatDidNot) {
  std::vector<DrawnQuantity> quantities = {{"rain", "start", {}}, {"jam", "magnitude", {}}, {"strike", "minutes", {}}};
  std::vector<double> metric;
  for (int i = 0; i < 40; ++i) {
    quantities[0].values.push_back((i * 17) % 40);
    quantities[1].values.push_back((i * 7) % 40);
    quantities[2].values.push_back((i * 11) % 40);
    metric.push_back(100.0 + std::pow((i * 7) % 40, 2) + (i * 13) % 5);
  }
  const auto found = influences(quantities, metric);
  EXPECT_EQ(found[0].fault, "jam");
  EXPECT_GT(found[0].correlation.mean, 0.95);
  EXPECT_LE(found[0].p_adjusted, 0.001);
  EXPECT_GT(found[0].p, 0.0) << "no number of random orders shows that it is impossible";
  EXPECT_GT(found[1].p_adjusted, 0.05);
  EXPECT_GT(found[2].p_adjusted, 0.05);
}

TEST(FaultInfluence, LeavesDrawsOutThatDoNotHaveTheFault) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto found = influences({{"jam", "start", {1, none, 2, none, none, 3, none, none, none, none}}}, lost_by_draw);
  EXPECT_EQ(found[0].draws, 3);
  EXPECT_FALSE(is_known(found[0].correlation)) << "three draws say nothing";
  EXPECT_EQ(influences({{"jam", "start", std::vector<double>(10, none)}}, lost_by_draw)[0].correlation.mean, 0.0);
}

Fault fault_of(const std::string& name, int start, std::vector<int> regions, double magnitude) {
  Fault fault;
  fault.name = name;
  fault.regions = std::move(regions);
  fault.start = start;
  fault.duration = 30;
  fault.magnitudes.assign(fault.regions.size(), magnitude);
  return fault;
}

TEST(DrawnQuantities, AreWhatDiffersBetweenDraws) {
  std::vector<Schedule> draws(6);
  for (int i = 0; i < 6; ++i) {
    auto& faults = draws[static_cast<std::size_t>(i)].faults;
    faults.push_back(fault_of("jam-9", 10 * i, {i % 2}, 2.0));
    for (int time = 1; time <= i % 3; ++time) {
      faults.push_back(fault_of("outage-" + std::to_string(time), 60 * time + i, {4}, 1.0 + i));
    }
  }
  std::map<std::string, std::vector<double>> found;
  for (const auto& drawn : drawn_quantities(draws, 300)) {
    found[drawn.fault + " " + drawn.quantity] = drawn.values;
  }
  EXPECT_EQ(found.at("jam-9 start"), (std::vector<double>{300, 310, 320, 330, 340, 350}));
  EXPECT_EQ(found.at("jam-9 in region 0"), (std::vector<double>{1, 0, 1, 0, 1, 0}));
  EXPECT_FALSE(found.contains("jam-9 minutes")) << "which are the same in all draws";
  EXPECT_EQ(found.at("outage times"), (std::vector<double>{0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(found.at("outage minutes"), (std::vector<double>{0, 30, 60, 0, 30, 60}));
  EXPECT_EQ(found.at("outage magnitude"), (std::vector<double>{0, 2, 6, 0, 5, 12}));
  EXPECT_TRUE(std::isnan(found.at("outage start")[0]));
  EXPECT_EQ(found.at("outage start")[5], 365.0);
  EXPECT_FALSE(found.contains("outage in region 4")) << "two draws without it are too few";
}

}  // namespace
}  // namespace evbal

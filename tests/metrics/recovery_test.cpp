#include "experiments/metrics/recovery.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

using Curve = std::vector<double>;
using Minutes = std::optional<int>;

/// Steps of 30 minutes; without faults the greatest value is 8, so that the band is 2.
const Curve quiet = {4, 4, 8, 4, 4, 4, 4, 4};

FaultCost cost_of(const Curve& with, const std::vector<FaultWindow>& faults, const Curve& without = quiet) {
  return fault_cost({with, without, 30}, false, faults);
}

TEST(Recovery, CountsWhatAFaultCosts) {
  const FaultCost cost = cost_of({4, 9, 6, 4, 4, 4, 4, 4}, {{30, 60}});
  EXPECT_EQ(cost.with, 39.0);
  EXPECT_EQ(cost.without, 36.0);
  EXPECT_EQ(cost.cost(), 3.0);
  EXPECT_DOUBLE_EQ(cost.area, 3.5);
  EXPECT_DOUBLE_EQ(cost.signed_area, 1.5);
  EXPECT_EQ(cost.band, 2.0);
}

TEST(Recovery, TakesTheMeanOfAStock) {
  const FaultCost cost = fault_cost({quiet, quiet, 30}, true, {});
  EXPECT_EQ(cost.with, 4.5);
  EXPECT_EQ(cost.cost(), 0.0);
  EXPECT_EQ(cost.area, 0.0);
}

TEST(Recovery, EndsWithTheStepFromWhichTheCurveStaysInTheBand) {
  EXPECT_EQ(cost_of({4, 9, 12, 9, 4, 4, 4, 4}, {{30, 60}}).recovered, Minutes(60));
  EXPECT_EQ(cost_of({4, 9, 12, 4, 4, 9, 4, 4}, {{30, 60}}).recovered, Minutes(120)) << "it was out once more";
  EXPECT_EQ(cost_of({4, 9, 8, 4, 4, 4, 9, 4}, {{30, 60}}).recovered, Minutes(0)) << "out again after two hours";
  EXPECT_EQ(cost_of({4, 9, 10, 6, 6, 6, 6, 6}, {{30, 60}}).recovered, Minutes(0)) << "at the band's edge";
  EXPECT_EQ(cost_of({4, 9, 12, 9, 4, 4, 4, 4}, {{30, 70}}).recovered, Minutes(50)) << "from its end";
}

TEST(Recovery, MayNeverCome) {
  EXPECT_EQ(cost_of({4, 4, 8, 7, 4, 7, 4, 7}, {{30, 60}}).recovered, Minutes());
  EXPECT_EQ(cost_of(quiet, {{30, 500}}).recovered, Minutes()) << "the fault outlasts the day";
}

TEST(Recovery, OfAFaultHasUntilTheNextBegins) {
  const Curve with = {4, 9, 8, 4, 9, 9, 4, 4};
  const FaultCost cost = cost_of(with, {{30, 60}, {120, 165}, {0, 110}});
  EXPECT_EQ(cost.by_fault, (std::vector<Minutes>{0, 15, 0}));
  EXPECT_EQ(cost.recovered, Minutes(15));
  EXPECT_EQ(cost_of(with, {{30, 60}, {70, 165}}).by_fault[0], Minutes()) << "the next one leaves it no step";
}

RC_GTEST_PROP(Recovery, IsSoundForAnyCurves, ()) {
  const auto curve = [] {
    const auto whole = *rc::gen::container<std::vector<int>>(12, rc::gen::inRange(0, 20));
    return Curve(whole.begin(), whole.end());
  };
  const Curve with = curve();
  const Curve without = curve();
  const int start = *rc::gen::inRange(0, 300);
  const FaultWindow fault{start, start + *rc::gen::inRange(1, 100)};
  const FaultCost cost = cost_of(with, {fault}, without);
  RC_ASSERT(std::abs(cost.signed_area) <= cost.area + 1e-9);
  RC_ASSERT(std::abs(cost.signed_area - cost.cost() / 2.0) < 1e-9);
  RC_ASSERT(cost.recovered == cost.by_fault[0]);
  RC_ASSERT(!cost.recovered || (*cost.recovered >= 0 && fault.end + *cost.recovered < 360));
  const FaultCost same = cost_of(without, {fault}, without);
  RC_ASSERT(same.area == 0.0);
  RC_ASSERT(same.recovered == (fault.end < 360 ? Minutes(0) : Minutes()));
}

}  // namespace
}  // namespace evbal

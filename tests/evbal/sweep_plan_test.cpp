#include "tools/evbal/sweep_plan.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

Sweep two_variants() {
  Sweep sweep;
  for (const std::string variant : {"slow", "slow", "slow", "quick", "quick"}) {
    sweep.days.push_back(
        {.scenario = "toy", .variant = variant, .faults = {}, .day = {}, .yaml = YamlValue::parse("{}", "toy")});
  }
  return sweep;
}

const std::vector<std::string> keys = {"a", "b", "c", "d", "e"};

TEST(SweepPlan, ForeseesByWhatDaysOfTheVariantTook) {
  EXPECT_EQ(sweep_plan(two_variants(), keys, {{"a", 90.0}, {"d", 1.0}, {"of another sweep", 5.0}}, {{"c", "why"}}, 2),
            "scenario  variant  days  played  left  failed  seconds a day   time left\n"
            "toy       slow        3       1     2       1           90.0  1 min 30 s\n"
            "toy       quick       2       1     1       0            1.0         1 s\n"
            "5 days, 3 left, of which 1 failed; with 2 at a time: 1 min 31 s\n");
}

TEST(SweepPlan, SaysWhenThereIsNoSaying) {
  const std::string plan = sweep_plan(two_variants(), keys, {{"a", std::nullopt}, {"d", 1.0}, {"e", 1.0}}, {}, 1);
  EXPECT_NE(plan.find("toy       slow        3       1     2       0                 not known\n"), std::string::npos)
      << plan;
  EXPECT_NE(plan.find("2 left; with 1 at a time: not known before a day of each variant is played\n"),
            std::string::npos)
      << plan;
}

}  // namespace
}  // namespace evbal

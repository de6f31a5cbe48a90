#include "tools/evbal/compared_csv.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace evbal {
namespace {

TEST(ComparedCsv, HoldsARowAComparisonAndLeavesOutWhatIsNotKnown) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Question question{.metric = "lost", .reference = "ref", .at = "idle_km"};
  const Compared whole{.scenario = "a, b",
                       .faults = "calm",
                       .variant = "new",
                       .whole = true,
                       .days = 1,
                       .apart = 2,
                       .points = 6,
                       .inside = 3,
                       .from = 10,
                       .to = 20,
                       .covered = 0.5,
                       .value = 30,
                       .reference = 40,
                       .difference = {-0.25, -infinity, infinity}};
  const Compared apart{
      .scenario = "s", .faults = "calm", .variant = "new", .settings = "price=1", .days = 0, .apart = 7};
  const PrimaryAnswer primary{.section = "One", .question = question, .row = whole, .p_holm = 0.5};
  EXPECT_EQ(
      compared_csv({{question, {whole, apart}}}, {primary}),
      "scenario,faults,variant,settings,metric,reference_variant,at,whole,days,apart,points,inside,from,to,covered,"
      "value,reference,of_totals,relative,difference,low,high,p,p_holm,way\n"
      "\"a, b\",calm,new,,lost,ref,idle_km,true,1,2,6,3,10,20,0.5,30,40,-0.25,true,-0.25,,,1,0.5,\n"
      "s,calm,new,price=1,lost,ref,idle_km,false,0,7,0,0,,,,,,,,,,,,,\n");
}

}  // namespace
}  // namespace evbal

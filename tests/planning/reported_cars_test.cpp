// Plans ask for cars that are there: of those that may charge where they stand, and of those that get where they are
// sent.

#include "coordinator/balancing/controllers.hpp"
#include "coordinator/planning/receding_horizon_planner.hpp"
#include "tests/planning/planner_fixture.hpp"
#include "tests/planning/small_city.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

using testing::at;
using testing::quiet_reports;

TEST(ReportedCars, TopUpWhereTheWorldKnowsThat) {
  const auto moves = [](bool top_up, const std::string& controller) {
    City city = testing::small_city();
    city.charging.top_up = top_up;
    PlanningSettings settings;
    settings.controller = controller;
    settings.balancing.omega = 0.0;  // else the points are kept for cars that run low in the second step
    settings.balancing.p_shortage = settings.balancing.p_flow = 0.1;
    RecedingHorizonPlanner planner(city, {}, testing::date, settings, testing::small_model());
    auto reports = quiet_reports(0, 20);
    for (Report& report : reports) {
      report.points = city.points()(report.region);
      report.chargeable = 15;
    }
    return planner.plan(at(0), reports).moves;
  };
  for (const auto& controller : controller_names()) {
    const auto tops_up = [](const Move& move) { return move.errand == Errand::charge && move.from == move.to; };
    EXPECT_EQ(std::ranges::count_if(moves(false, controller), tops_up), 0) << controller;
    EXPECT_EQ(std::ranges::count_if(moves(true, controller), tops_up), controller == "none" ? 0 : 2) << controller;
  }
}

// A region whose only low-battery car is all but empty is not asked to send it, whatever that would be worth.
TEST(ReportedCars, AreSentWhereTheyGet) {
  for (const auto& controller : controller_names()) {
    PlanningSettings settings;
    settings.controller = controller;
    RecedingHorizonPlanner planner(testing::small_city(), {}, testing::date, settings, testing::small_model());
    auto reports = quiet_reports(0, 5);
    reports[0].points = 2;
    reports[1].points = 1;
    reports[2].low_battery = 3;
    reports[2].reach_m = {4999, 5000, 9000};
    for (const Move& move : planner.plan(at(0), reports).moves) {
      const bool of_low_battery = move.errand == Errand::charge;
      EXPECT_LE(of_low_battery ? move.count : 0, move.to == 1 ? 2 : 0) << controller << ", to " << move.to;
    }
  }
}

}  // namespace
}  // namespace evbal

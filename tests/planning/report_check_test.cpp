#include "coordinator/planning/report_check.hpp"

#include "agents/protocol/reflection.hpp"
#include "tests/region/plant_fixture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

namespace evbal {
namespace {

const ReportBounds bounds{.vehicles = 20, .points = {4, 0}, .clock = {}};

Report sound() {
  Report report;
  report.tick = 6;
  report.vacant = 3;
  report.chargeable = 3;
  report.low_battery = 2;
  report.reach_m = {0, 900};
  report.plugged = 2;
  report.points = 4;
  report.plugged_since = {5, 20};
  report.bound = {{0, 31, Errand::passenger, 4}, {0, 40, Errand::charge, 1}};
  return report;
}

TEST(ReportCheck, BelievesWhatCanBe) {
  EXPECT_EQ(validate(sound(), 6, 4, bounds), "");
}

TEST(ReportCheck, SaysWhatCannotBe) {
  const auto expect_invalid = [](const std::string& expected, const std::function<void(Report&)>& spoil) {
    Report report = sound();
    spoil(report);
    EXPECT_EQ(validate(report, 6, 4, bounds), expected);
  };
  expect_invalid("is of tick 4", [](Report& r) { r.tick = 4; });
  expect_invalid("waiting -1", [](Report& r) { r.waiting = -1; });
  expect_invalid("points 5, installed 4", [](Report& r) { r.points = 5; });
  expect_invalid("plugged 2, points 1", [](Report& r) { r.points = 1; });
  expect_invalid("vehicles 21, fleet 20", [](Report& r) { r.vacant = 12; });
  expect_invalid("vehicles 6442450944, fleet 20",
                 [](Report& r) { r.vacant = r.low_battery = r.bound[0].count = 2147483647; });
  expect_invalid("completions 41, possible 40", [](Report& r) { r.completions = 41; });
  expect_invalid("demand and waiting 2147483647, possible 1140000", [](Report& r) { r.demand = 2147483647; });
  expect_invalid("chargeable 4, vacant 3", [](Report& r) { r.chargeable = 4; });
  expect_invalid("chargeable -7", [](Report& r) { r.chargeable = -7; });
  expect_invalid("low_battery 1, reach_m 2", [](Report& r) { r.low_battery = 1; });
  expect_invalid("reach_m is not in order or below zero", [](Report& r) { r.reach_m = {900, 0}; });
  expect_invalid("reach_m is not in order or below zero", [](Report& r) { r.reach_m = {-1}; });
  expect_invalid("plugged 3, plugged_since 2", [](Report& r) { r.plugged = 3; });
  expect_invalid("plugged_since is not in order or not of the day", [](Report& r) { r.plugged_since[1] = 31; });
  expect_invalid("bound has cars to elsewhere, none, or of the past", [](Report& r) { r.bound[0].region = 1; });
  expect_invalid("bound has cars to elsewhere, none, or of the past", [](Report& r) { r.bound[0].count = 0; });
  expect_invalid("bound has cars to elsewhere, none, or of the past", [](Report& r) { r.bound[1].minute = 29; });
}

TEST(ReportCheck, BelievesTheFirstOfTwo) {
  Report other = sound();
  other.vacant = 4;
  const CheckedReports checked = check_reports({sound(), other}, 6, 4, bounds);
  EXPECT_EQ(checked.good[0]->vacant, 3);
  EXPECT_EQ(checked.rejected, (std::vector<Rejection>{{0, "came twice"}, {1, "is missing"}}));
}

/// Any number in any field.
struct Garble {
  template <class Field>
  void operator()(std::string_view /*name*/, Field& field) const {
    if constexpr (std::is_enum_v<Field>) {
      field = static_cast<Field>(*rc::gen::inRange(0, 3));
    } else if constexpr (std::is_arithmetic_v<Field>) {
      field = *rc::gen::inRange(0, 3) == 0 ? *rc::gen::arbitrary<Field>() : field;
    } else {
      for_each_field(field, *this);
    }
  }

  template <class Item>
  void operator()(std::string_view name, std::vector<Item>& items) const {
    items.resize(static_cast<std::size_t>(*rc::gen::inRange(0, 4)));
    for (Item& item : items) {
      (*this)(name, item);
    }
  }
};

RC_GTEST_PROP(ReportCheck, WhatIsBelievedIsWithinBounds, ()) {
  std::vector<Report> reports(static_cast<std::size_t>(*rc::gen::inRange(0, 4)), sound());
  for (Report& report : reports) {
    Garble{}("", report);
  }
  const CheckedReports checked = check_reports(reports, 6, 4, bounds);
  std::size_t believed = 0;
  for (const auto& report : checked.good) {
    believed += report ? 1U : 0U;
    RC_ASSERT(!report || (report->vacant >= 0 && report->vacant + report->low_battery + report->plugged <= 20));
    RC_ASSERT(!report || report->plugged <= report->points);
    RC_ASSERT(!report || report->chargeable <= report->vacant);
  }
  RC_ASSERT(checked.rejected.size() + believed >= std::max<std::size_t>(2, reports.size()));
}

// What plants say without faults of sensors is always believed.
RC_GTEST_PROP(ReportCheck, BelievesPlants, ()) {
  const World world = *test::small_worlds();
  const auto faults = *test::faults_for(world);
  const Eigen::VectorXi points = world.city.points();
  const ReportBounds real{world.city.fleet.vehicles, {points.begin(), points.end()}, world.clock};
  auto plants = make_plants(world);
  int last = 0;
  for (int tick = 0; tick < world.clock.ticks(); ++tick) {
    for (auto& plant : plants) {
      Tick announced;
      announced.tick = tick;
      announced.effects = faults[tick].effects;
      plant.begin(announced);
      if (world.clock.plan_due(tick)) {
        RC_ASSERT(validate(plant.report(), tick, last, real) == "");
      }
      plant.live(nullptr);
    }
    last = world.clock.plan_due(tick) ? tick : last;
  }
}

}  // namespace
}  // namespace evbal

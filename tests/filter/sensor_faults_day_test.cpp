// Whole days of the toy city under sensor faults, planned with the filter.

#include "experiments/run/record_day.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

Scenario toy(SensorFaults sensor_faults, std::vector<Fault> faults) {
  Scenario scenario = read_scenario(test::in_source("experiments/scenarios/toy.yaml"));
  scenario.planning.controller = "robust";
  scenario.planning.engine.name = "cuts";
  scenario.planning.sensor_faults = sensor_faults;
  scenario.schedule.faults = std::move(faults);
  return scenario;
}

Fault lie(EffectType type, ReportField field, double magnitude = 0.0) {
  return {.name = "lie",
          .type = type,
          .regions = {1},
          .magnitudes = {magnitude},
          .start = 5 * 60,
          .duration = 3 * 60,
          .field = field};
}

TEST(SensorFaultsDay, WithoutLiesIsTheDayThatIgnoresThem) {
  const std::string ignored = play_day(toy(SensorFaults::ignore, {})).digest;
  EXPECT_EQ(play_day(toy(SensorFaults::flag, {})).digest, ignored);
  EXPECT_EQ(play_day(toy(SensorFaults::isolate, {})).digest, ignored);
}

TEST(SensorFaultsDay, RaisesNoAlarmForASpike) {
  const Fault spike{.name = "spike",
                    .type = EffectType::demand_scale,
                    .regions = {1, 4},
                    .magnitudes = {3.0, 3.0},
                    .start = 5 * 60,
                    .duration = 3 * 60,
                    .visible = false};
  EXPECT_EQ(play_day(toy(SensorFaults::isolate, {spike})).metrics.totals.detection.false_alarms, 0);
}

TEST(SensorFaultsDay, FindsWhichFieldOfWhichRegionLies) {
  for (const Fault& fault :
       {lie(EffectType::sensor_biased, ReportField::vacant, 6.0),
        lie(EffectType::sensor_biased, ReportField::vacant, -4.0),
        lie(EffectType::sensor_biased, ReportField::low_battery, 6.0),
        lie(EffectType::sensor_biased, ReportField::demand, 6.0), lie(EffectType::sensor_off, ReportField::vacant),
        lie(EffectType::sensor_off, ReportField::demand), lie(EffectType::sensor_off, ReportField::plugged),
        lie(EffectType::sensor_noisy, ReportField::vacant, 5.0),
        lie(EffectType::sensor_biased, ReportField::points, -1.0)}) {
    const Detection found = play_day(toy(SensorFaults::isolate, {fault})).metrics.totals.detection;
    EXPECT_EQ(found.lies,
              fault.type == EffectType::sensor_biased && fault.field == ReportField::points ? found.lies : 1);
    EXPECT_EQ(found.found_30, found.lies)
        << static_cast<int>(fault.type) << " of field " << static_cast<int>(fault.field);
    EXPECT_EQ(found.false_alarms, 0) << static_cast<int>(fault.type) << " of field " << static_cast<int>(fault.field);
  }
}

}  // namespace
}  // namespace evbal

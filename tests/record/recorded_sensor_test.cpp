#include "experiments/record/recorded_sensor.hpp"

#include "tests/folder.hpp"
#include "tests/record/small_day.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(RecordedSensor, HoldsTruthReportAndEstimate) {
  std::vector<TickRecord> day = small_day();
  day[2].exchange.reports[0].vacant = 9;
  day[2].exchange.reports[1].demand = 6;
  day[2].exchange.plan->provenance.flags = {
      {.region = 0, .field = ReportField::vacant, .kind = SensorFaultKind::biased, .reported = 9, .estimate = 2},
      {.region = 1, .field = ReportField::demand, .kind = SensorFaultKind::stuck, .reported = 6, .estimate = 1}};
  const Folder folder;
  {
    DayFile file(folder.path() / "run.sqlite", {"a", "b"}, {0, 2}, {});
    for (const TickRecord& record : day) {
      file.add(record);
    }
    file.commit();
  }
  const auto sensors = read_sensors(folder.path() / "run.sqlite", 8);
  ASSERT_EQ(sensors.size(), 2U);
  EXPECT_EQ(sensors[0].field, "vacant");
  EXPECT_EQ(sensors[0].kinds, std::vector<std::string>{"biased"});
  ASSERT_EQ(sensors[0].readings.size(), 2U);
  EXPECT_EQ(sensors[0].readings[0].reported, 3);
  EXPECT_FALSE(sensors[0].readings[0].estimate);
  EXPECT_FALSE(sensors[0].readings[0].truth) << "nobody has said yet how the region stands";
  EXPECT_EQ(sensors[0].readings[1].reported, 9);
  EXPECT_EQ(sensors[0].readings[1].estimate, 2);
  EXPECT_EQ(sensors[0].readings[1].truth, 1.0);
  EXPECT_EQ(sensors[1].field, "demand");
  EXPECT_EQ(sensors[1].readings[1].truth, 1.0) << "of both ticks since the plan before";
  EXPECT_EQ(read_sensors(folder.path() / "run.sqlite", 1).size(), 1U);
}

}  // namespace
}  // namespace evbal

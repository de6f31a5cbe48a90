#include "tools/ingest/ingest_counts.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

const std::string kNotes = R"(name: town
source: a test
day_start: "06:00"
step: 60min
days: {train: [2024-03-04], test: [2024-03-05], holidays: [2024-03-05]}
counts:
  columns: {time: [date, time], from: from, to: to, trips: trips}
  time: "%Y-%m-%d %H:%M"
  zone_field: id
  share: 1
  seed: 1
sample:
  columns: {start: begin, end: end, from: from, to: to, distance: miles}
  time: "%Y-%m-%d %H:%M:%S"
  km: 1.6
  shortest: 1min
  longest: 120min
  fastest_kmh: 120
fleet: {vehicles: 40, battery_kwh: 20, km_per_kwh: 5.5, initial_charge: [0.3, 0.9]}
stations: {columns: {name: id, lat: lat, lon: lon, points: [n]}, share: 0.5, snap_m: 500, power_kw: 50}
sessions:
  columns: {start: begin, end: end}
  time: unix
  model: none
  shortest: 10min
  longest: 90min
passengers: {patience: [8min, 20min]}
)";

/// Four zones of 0.02 x 0.015 degrees, from south-west to north-east.
std::string zones_of_counts() {
  std::string text = "{\"type\": \"FeatureCollection\", \"features\": [";
  for (int zone = 0; zone < 4; ++zone) {
    const double west = 9.70 + 0.02 * (zone % 2);
    const double south = 52.34 + 0.015 * static_cast<int>(zone / 2);
    const auto corner = [](double lon, double lat) {
      return "[" + std::to_string(lon) + ", " + std::to_string(lat) + "]";
    };
    text += std::string(zone > 0 ? ", " : "") + R"({"type": "Feature", "properties": {"id": )" + std::to_string(zone) +
            R"(}, "geometry": {"type": "Polygon", "coordinates": [[)" + corner(west, south) + ", " +
            corner(west + 0.02, south) + ", " + corner(west + 0.02, south + 0.015) + ", " +
            corner(west, south + 0.015) + ", " + corner(west, south) + "]]}}";
  }
  return text + "]}";
}

std::string two(int number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

class IngestCounts : public testing::Test {
 protected:
  IngestCounts() {
    sources_ = {folder_.path() / "counts",
                folder_.write("zones.geojson", zones_of_counts()),
                folder_.path() / "sample.csv",
                folder_.write("stations.csv", "id,lat,lon,n\na,52.347,9.71,3\nb,52.362,9.73,5\n"),
                folder_.path() / "sessions",
                folder_.write("notes.yaml", kNotes),
                4};
    folder_.write("sessions/s.csv", "begin,end\n0,1200\n0,1800\n0,2400\n");
    folder_.write("counts/a.csv", header + rows("2024-03-04") + rows("2024-03-05"));
    folder_.write("sample.csv", sample());
  }

  /// Ten trips an hour from zone 0 to 3, one back.
  static std::string rows(const std::string& date) {
    std::string text;
    for (int hour = 6; hour < 24; ++hour) {
      text += date + "," + two(hour) + ":00,0,3,10\n" + date + "," + two(hour) + ":00,3,0,1\n";
    }
    return text;
  }

  /// 1200 trips of 4 km from zone 0 to 3, in 10 minutes by night and 20 from 8 to 20 o'clock; and 1200 of 1.5 km within
  /// zone 0, in 4 and 8 minutes.
  static std::string sample() {
    std::string text = "begin,end,from,to,miles\n";
    for (int trip = 0; trip < 2400; ++trip) {
      const int hour = trip % 24;
      const bool by_day = hour >= 8 && hour < 20;
      const bool is_long = trip < 1200;
      const int minutes = (is_long ? 10 : 4) * (by_day ? 2 : 1);
      text += "2024-03-04 " + two(hour) + ":05:00,2024-03-04 " + two(hour) + ":" + two(5 + minutes) + ":00,0," +
              (is_long ? "3,2.5\n" : "0,0.945\n");
    }
    return text;
  }

  void set(const std::string& from, const std::string& to) {
    std::string notes = text_of(sources_.notes);
    notes.replace(notes.find(from), from.size(), to);
    folder_.write("notes.yaml", notes);
  }

  void expect_refused(const std::string& reason) {
    try {
      ingest_counts(sources_);
      FAIL() << "was accepted, expected: " << reason;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  static int trips_of(const DemandDay& day) {
    int trips = 0;
    for (const auto& step : day.steps) {
      for (const TripCount& pair : step) {
        trips += pair.trips;
      }
    }
    return trips;
  }

  const std::string header = "date,time,from,to,trips\n";
  Folder folder_;
  CountSources sources_;
};

TEST_F(IngestCounts, MakesACityThatCanBeReadBack) {
  const IngestedCity made = ingest_counts(sources_);
  write_city(made.city, made.days, folder_.path() / "pack");
  const City city = read_city(folder_.path() / "pack");
  EXPECT_EQ(city.name, "town-4");
  ASSERT_EQ(city.size(), 4);
  const DemandDay day = read_demand(city, "2024-03-05");
  EXPECT_TRUE(day.holiday);
  ASSERT_EQ(day.steps.size(), 18U);
  ASSERT_EQ(day.steps[3].size(), 2U);
  EXPECT_EQ(trips_of(day), 198);
  EXPECT_EQ(city.points().sum(), 4);
  EXPECT_EQ(city.charging.session_quantiles[10], 30.0);
  for (const std::string line : {"count rows read: 72\n", "trips: 396 on 2 days\n", "trips of the sample used: 2400",
                                 "points for the fleet: 4 at 2 stations", "sessions used: 3, median 30 min"}) {
    EXPECT_NE(made.report.find(line), std::string::npos) << line << " not in\n" << made.report;
  }
}

TEST_F(IngestCounts, FitsTravelByTheHour) {
  const IngestedCity made = ingest_counts(sources_);
  // 12 of 18 hours are slow: 16.7 min on average, drawn towards the sample's 15.
  const DemandDay& day = made.days[0];
  const TripCount& there = day.steps[0][0].trips == 10 ? day.steps[0][0] : day.steps[0][1];
  EXPECT_NEAR(made.city.minutes(there.origin, there.destination), 16.1, 0.3);
  EXPECT_NEAR(made.city.km(there.origin, there.destination), 4.0, 0.1);
  EXPECT_LT(made.city.minutes(there.origin, there.origin), 8.0);
  set("step: 60min", "step: 30min");
  expect_refused("has no trip in the step from minute 390 of any day; are the counts by longer steps?");
}

TEST_F(IngestCounts, ThinsByASeededDraw) {
  set("share: 1\n", "share: 0.3\n");
  folder_.write("counts/a.csv", header + "2024-03-04,09:00,1,2,20000\n" + rows("2024-03-04") + rows("2024-03-05"));
  const IngestedCity made = ingest_counts(sources_);
  const int drawn = trips_of(made.days[0]);
  EXPECT_NEAR(drawn, 0.3 * 20198, 4.0 * std::sqrt(20198 * 0.3 * 0.7));
  folder_.write("counts/a.csv", header + rows("2024-03-05"));  // the same rows in another order and in two files
  folder_.write("counts/b.csv",
                header + rows("2024-03-04") + "2024-03-04,09:00,1,2,15000\n2024-03-04,09:00,1,2,5000\n");
  const IngestedCity again = ingest_counts(sources_);
  EXPECT_EQ(trips_of(again.days[0]), drawn);
  EXPECT_EQ(trips_of(again.days[1]), trips_of(made.days[1]));
  EXPECT_NE(again.report.find("given before, added up: 1\n"), std::string::npos) << again.report;
  set("seed: 1", "seed: 2");
  EXPECT_NE(trips_of(ingest_counts(sources_).days[0]), drawn);
}

TEST_F(IngestCounts, CountsWhatItDropsByReason) {
  folder_.write("counts/b.csv", header +
                                    "2024-03-04,05:30,0,3,10\n2024-03-06,09:00,0,3,10\n03/04/2024,09:00,0,3,10\n"
                                    "2024-03-04,09:00,0,9,10\n2024-03-04,09:00,0,3,ten\n2024-03-04,09:00,0,3,0\n");
  const IngestedCity made = ingest_counts(sources_);
  const std::string file = (folder_.path() / "counts/b.csv").string();
  for (const std::string& line :
       {"before the day's start: 1 (first: " + file + ":2: `2024-03-04 05:30`)",
        "on another day: 1 (first: " + file + ":3: `2024-03-06 09:00`)",
        "no time like `%Y-%m-%d %H:%M`: 1 (first: " + file + ":4: `03/04/2024 09:00`)",
        "in a zone without polygon; one that has it is `0`: 1 (first: " + file + ":5: `9`)",
        "no number of trips, 0 to 1000000: 1 (first: " + file + ":6: `ten`)", std::string("trips: 396 on 2 days")}) {
    EXPECT_NE(made.report.find(line), std::string::npos) << line << " not in\n" << made.report;
  }
}

TEST_F(IngestCounts, MayBeginWithZonesOfAnotherPlace) {
  std::string elsewhere;
  for (int row = 0; row < 150; ++row) {
    elsewhere += "2024-03-04,09:00,265,3,1\n";
  }
  folder_.write("counts/0.csv", header + elsewhere);
  const IngestedCity made = ingest_counts(sources_);
  EXPECT_NE(made.report.find("in a zone without polygon; one that has it is `0`: 150 (first: "), std::string::npos)
      << made.report;
  EXPECT_NE(made.report.find("trips: 396 on 2 days"), std::string::npos) << made.report;
}

TEST_F(IngestCounts, RefusesWhatCannotBeACity) {
  folder_.write("counts/a.csv", header + rows("2024-03-04"));
  expect_refused("has no trip of 2024-03-05");
  folder_.write("counts/a.csv", header + "4.3.2024,06:00,0,3,10\n");
  expect_refused("a.csv:2: no time like `%Y-%m-%d %H:%M`: `4.3.2024 06:00`; none of 1 rows can be read");
  folder_.write("counts/a.csv", header + rows("2024-03-04") + rows("2024-03-05"));
  folder_.write("sample.csv",
                "begin,end,from,to,miles\n2024-03-04 06:05:00,2024-03-04 06:15:00,0,3,2.5\n"
                "2024-03-04 06:05:00,2024-03-04 06:05:10,0,3,2.5\n");
  expect_refused("has 1 trips that count; a hundred at least are needed\n  dropped, too short in time: 1 (first: ");
  sources_.regions = 5;
  folder_.write("sample.csv", sample());
  expect_refused("5");
  sources_.regions = 4;
  set("time: \"%Y-%m-%d %H:%M\"", "time: unix");
  expect_refused("notes.yaml:8: unix seconds are no time that clocks show");
}

}  // namespace
}  // namespace evbal

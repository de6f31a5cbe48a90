// Tables of trips by zone as other programs write them: a whole town of each.

#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/ingest/town.hpp"
#include "tools/ingest/ingest_trips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <sstream>

namespace evbal {
namespace {

using namespace town;

const std::string kRawNotes = R"(name: my-town
source: drawn
utc_offset_minutes: 60
day_start: "05:00"
step: 30min
days: {train: [2024-03-04], test: [2024-03-05], holidays: []}
trips: {shortest: 1min, longest: 120min, fastest_kmh: 120, detour: 1.3}
zones: {reach_km: 20, snap_m: 500, apart: []}
fleet: {vehicles: 40, battery_kwh: 20, km_per_kwh: 5.5, initial_charge: [0.3, 0.9]}
charging: {power_kw: 50, stations: 2, points: 5, session_model: Rapid, shortest_session: 12min, longest_session: 90min}
passengers: {patience: [8min, 20min]}
)";
const std::string kFormat =
    "columns: {pickup_time: began, dropoff_time: ended, pickup_zone: from, dropoff_zone: to}\n"
    "time: local\nzone_field: LocationID\n";
constexpr int kTrips = 240;

using Cell = std::function<std::string(const std::string&)>;

std::string as_is(const std::string& text) {
  return text;
}

/// A table of 240 trips between all zones on both days; `time` and `zone` say how these are written.
std::string table(const Cell& zone, const Cell& time = as_is) {
  std::string rows = "vendor,began,ended,from,to\n";
  for (int trip = 0; trip < kTrips; ++trip) {
    const std::string hour = "2024-03-0" + std::to_string(4 + trip % 2) + " " + std::to_string(10 + trip % 12) + ":";
    rows += "2," + time(hour + "05:00") + "," + time(hour + "25:00") + "," + zone(std::to_string(1 + trip % 16)) + "," +
            zone(std::to_string(1 + trip / 16 % 16)) + "\n";
  }
  return rows;
}

class RawTrips : public testing::Test {
 protected:
  RawTrips() {
    folder_.write("zones.geojson", collection(features()));
    folder_.write("format.yaml", kFormat);
    folder_.write("notes.yaml", kRawNotes);
    folder_.write("sessions/s.csv",
                  "Start Date,Start Time,End Date,End Time,Model\n01/12/2017,12:00,01/12/2017,12:20,Rapid\n");
  }

  /// The report on the town.
  std::string ingest() const {
    return ingest_trips({folder_.path() / "trips", folder_.path() / "format.yaml", folder_.path() / "zones.geojson",
                         folder_.path() / "sessions", folder_.path() / "notes.yaml", 4})
        .report;
  }

  void expect_used(int trips) const {
    const std::string report = ingest();
    EXPECT_NE(report.find("trips used: " + std::to_string(trips) + " on 2 days"), std::string::npos) << report;
  }

  void expect_report(const std::string& line) const {
    const std::string report = ingest();
    EXPECT_NE(report.find(line), std::string::npos) << report;
  }

  /// Each of `reasons` is said.
  void expect_refused(const std::vector<std::string>& reasons) const {
    try {
      ingest();
      FAIL() << "was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      for (const auto& reason : reasons) {
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
      }
    }
  }

  Folder folder_;
};

TEST_F(RawTrips, KnowZonesHoweverTheirNumberIsWritten) {
  const std::vector<std::pair<std::string, Cell>> forms{
      {"as it is", as_is},
      {"as pandas writes a column with a blank", [](const std::string& id) { return id + ".0"; }},
      {"with zeros", [](const std::string& id) { return std::string(4 - id.size(), '0') + id; }},
      {"with blanks", [](const std::string& id) { return " " + id + " "; }},
      {"quoted", [](const std::string& id) { return "\"" + id + "\""; }}};
  for (const auto& [name, form] : forms) {
    SCOPED_TRACE(name);
    folder_.write("trips/t.csv", table(form));
    expect_used(kTrips);
  }
  auto padded = features();
  for (int zone = 0; zone < 16; ++zone) {
    const std::string id = std::to_string(zone + 1);
    padded[zone] = feature(named("\"" + std::string(4 - id.size(), '0') + id + "\""), polygon(square(zone)));
  }
  folder_.write("zones.geojson", collection(padded));
  folder_.write("trips/t.csv", table([](const std::string& id) { return id + ".0"; }));
  expect_used(kTrips);
}

TEST_F(RawTrips, MayMixTheFormsOfNumbersFromFileToFile) {
  folder_.write("trips/a.csv", table(as_is));
  folder_.write("trips/b.csv", table([](const std::string& id) { return id + ".0"; }));
  expect_used(2 * kTrips);
}

TEST_F(RawTrips, MayHaveSemicolonsAndDecimalCommas) {
  std::string text = table([](const std::string& id) { return id + ".0"; });
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace(text.begin(), text.end(), '.', ',');
  folder_.write("trips/t.csv", text);
  folder_.write("format.yaml", "separator: semicolon\ndecimal: comma\n" + kFormat);
  expect_used(kTrips);
}

TEST_F(RawTrips, MayStandBelowOtherLines) {
  folder_.write("trips/t.csv", "Trips of March\n\"all of them\n\n" + table(as_is));
  expect_refused({"t.csv:1: has no column `began`", "named in line 4: give `skip_rows`"});
  folder_.write("format.yaml", "skip_rows: 3\n" + kFormat);
  expect_used(kTrips);
}

TEST_F(RawTrips, MayHaveColumnsOfAnyLength) {
  const std::string wide = ",\"[" + std::string(85'000, '8') + "\n]\"";
  std::istringstream lines(table(as_is));
  std::string text;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    text += line + (number == 1 ? ",polyline" : number % 50 == 0 ? wide : ",x") + "\n";
  }
  folder_.write("trips/t.csv", text);
  expect_used(kTrips);
}

TEST_F(RawTrips, AreSpreadOverAllPolygonsOfAZone) {
  auto all = features();
  all[10] = feature(named("1"), polygon(square(10)));
  all[15] = feature(named("1"), polygon(square(15)));
  folder_.write("zones.geojson", collection(all));
  folder_.write("trips/t.csv", table([](const std::string& id) { return id == "11" || id == "16" ? "1" : id; }));
  expect_used(kTrips);
  expect_report("polygons put to another of the same name: 2");
}

TEST_F(RawTrips, SayWhichZonesHaveNoPolygon) {
  const auto spoilt = [](const std::string& id) { return id == "7" ? "265" : id; };
  folder_.write("trips/t.csv", table(spoilt));
  expect_report("dropped, in a zone without polygon: `from` is no `LocationID`, such as `1`: 15 (first: ");
  expect_report("t.csv:8: `265`)");
  folder_.write("trips/t.csv", table([](const std::string& id) { return "Z" + id; }));
  expect_refused({"no trip of the training days starts in a zone",
                  "`from` is no `LocationID`, such as `1`: 240 (first: ", "t.csv:2: `Z1`)", "rows read: 240"});
}

TEST_F(RawTrips, SayWhichFileIsLost) {
  folder_.write("trips/a.csv", table(as_is));
  folder_.write("trips/b.csv", table([](const std::string& id) { return "Z" + id; }));
  expect_report("files of which no row is used: 1 (first: " + (folder_.path() / "trips/b.csv").string());
}

TEST_F(RawTrips, SayWhatATimeMustLookLike) {
  const auto american = [](const std::string& time) { return "3/" + time.substr(9, 1) + "/2024" + time.substr(10); };
  folder_.write("trips/t.csv", table(as_is, american));
  expect_refused({"t.csv:2: `began` is no time written as 2008-05-18 07:31:05: `3/4/2024 10:05:00`; none of 100 rows"});
  folder_.write("trips/t.csv", "vendor,began,ended,from,to\n2,18.05.2008 07:31,18.05.2008 07:51,1,2\n");
  expect_refused({"t.csv:2: `began` is no time written as 2008-05-18 07:31:05: `18.05.2008 07:31`; none of 1 rows"});
  folder_.write("format.yaml",
                "header: false\ncolumns: {pickup_time: 2, dropoff_time: 3, pickup_zone: 4, dropoff_zone: 5}\n"
                "time: unix\nzone_field: LocationID\n");
  folder_.write("trips/t.csv", "2,07:31,07:51,1,2\n");
  expect_refused({"t.csv:1: column 2 is no number of seconds since 1970, such as 1211095865: `07:31`"});
}

TEST_F(RawTrips, SayWhereTripsAreIfNotInTheZones) {
  folder_.write(
      "format.yaml",
      "columns: {pickup_time: began, dropoff_time: ended, pickup_lat: from, pickup_lon: to, dropoff_lat: from, "
      "dropoff_lon: to}\ntime: local\n");
  folder_.write("trips/t.csv", table(as_is));
  expect_refused({"no trip of the training days starts in a zone; one starts at 1, 1, a zone lies at 52.3475, 9.71"});
}

TEST_F(RawTrips, SayWhatWasDroppedBeforeAFailure) {
  std::string text = table(as_is);
  for (auto at = text.find("2024-03-05"); at != std::string::npos; at = text.find("2024-03-05")) {
    text.replace(at, 10, "2024-04-05");
  }
  folder_.write("trips/t.csv", text);
  expect_refused({"has no trip of 2024-03-05",
                  "dropped, on another day: 120 (first: ", "t.csv:3: `2024-04-05 11:05:00`", "zones read: 16"});
  folder_.write("trips/u.csv", "vendor,began,ended\n");
  expect_refused({"u.csv:1: has no column `from`", "dropped, on another day: 120"});
}

TEST_F(RawTrips, UseZonesThatTouchNoOther) {
  constexpr double kStreet = 0.0002;  // degrees, some 20 m
  folder_.write("zones.geojson", collection(features(in_degrees, kStreet)));
  folder_.write("trips/t.csv", table(as_is));
  expect_used(kTrips);
}

TEST_F(RawTrips, UseAnIslandAsBusyAsTheRest) {
  auto all = features();
  for (int zone = 8; zone < 16; ++zone) {
    const auto north = [](double lon, double lat) { return in_degrees(lon, lat + 0.02); };
    all[zone] = feature(named(std::to_string(zone + 1)), polygon(square(zone, north)));
  }
  folder_.write("zones.geojson", collection(all));
  folder_.write("trips/t.csv", table(as_is));
  expect_used(kTrips);
}

TEST_F(RawTrips, SayWhichIslandsAreLeftOut) {
  auto all = features();
  const auto far = [](double lon, double lat) { return in_degrees(lon, lat + 0.1); };
  const auto further = [](double lon, double lat) { return in_degrees(lon, lat + 1.0); };
  all.push_back(feature(named("17"), polygon(square(12, far))));
  all.push_back(feature(named("18"), polygon(square(13, further))));
  folder_.write("zones.geojson", collection(all));
  std::string text = table(as_is);
  text += "2,2024-03-04 12:00:00,2024-03-04 12:20:00,17,1\n2,2024-03-04 12:00:00,2024-03-04 12:20:00,18,1\n";
  folder_.write("trips/t.csv", text);
  expect_used(kTrips);
  expect_report("dropped, zones on an island of few trips: 1 (first: `17`), trip ends: 1\n");
  expect_report("dropped, zones out of reach: 1 (first: `18`), trip ends: 1\n");
  expect_report("dropped, an end outside the regions: 2 (first: ");
  expect_report("t.csv:242: `17 to 1`)");
}

}  // namespace
}  // namespace evbal

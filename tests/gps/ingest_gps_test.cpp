#include "tools/gps/ingest_gps.hpp"

#include "agents/world/geometry.hpp"
#include "agents/world/regions_file.hpp"
#include "agents/world/stations_yaml.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/packed.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

namespace fs = std::filesystem;

const std::string kFormat = R"(separator: space
header: false
vehicle_in_name: "cab_*.txt"
columns: {lat: 1, lon: 2, occupied: 3, time: 4}
time: unix
occupied: "1"
free: "0"
utc_offset_minutes: -420
)";

constexpr long long kNoon = 1'211'137'200;  // 2008-05-18 12:00 in UTC-7

std::string row(long long time, double lat, double lon, bool occupied) {
  return std::to_string(lat) + " " + std::to_string(lon) + (occupied ? " 1 " : " 0 ") + std::to_string(time) + "\n";
}

class IngestGps : public testing::Test {
 protected:
  IngestGps() {
    const Outline west{{{37.7, -122.5}, {37.7, -122.45}, {37.75, -122.45}, {37.75, -122.5}}};
    const Outline east{{{37.7, -122.45}, {37.7, -122.4}, {37.75, -122.4}, {37.75, -122.45}}};
    const std::vector<Region> regions{{"west", west, {37.72, -122.47}}, {"east", east, {37.72, -122.42}}};
    sources_.gps = folder_.path() / "gps";
    sources_.format = folder_.write("format.yaml", kFormat);
    sources_.regions = folder_.write("regions.geojson", regions_geojson(regions));
    sources_.stations =
        folder_.write("stations.yaml", stations_yaml({{"hub, \"north\"", 1, 4, {37.72, -122.42}}}, regions));
  }

  /// Waits 20 minutes in the west, rides east, charges an hour there after a queue of 15 minutes, 120 m away.
  static std::string day_of_a_cab() {
    std::string rows;
    for (int minute = 0; minute < 120; ++minute) {
      const bool riding = minute >= 20 && minute < 40;
      const double lat = minute >= 40 && minute < 55 ? 37.7211 : 37.72;
      const double lon = -122.47 + 0.0025 * std::clamp(minute - 20, 0, 20);
      rows += row(kNoon + 60 * minute, minute < 110 ? lat : 37.74, lon, riding);
    }
    return rows;
  }

  std::string ingest() {
    fs::remove_all(folder_.path() / "out");
    fs::create_directory(folder_.path() / "out");
    return ingest_gps(sources_, folder_.path() / "out", [](const FixProgress&) {});
  }

  std::string table(const std::string& name) const { return text_of(folder_.path() / "out" / name); }

  void expect_refused(const std::string& reason) {
    try {
      ingest();
      FAIL() << "was accepted, expected: " << reason;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  Folder folder_;
  GpsSources sources_;
};

TEST_F(IngestGps, WritesWhatACabDid) {
  folder_.write("gps/cab_7.txt.xz", packed(day_of_a_cab(), "xz"));
  const std::string report = ingest();
  EXPECT_EQ(table("trips/trips.csv"),
            "cab,pickup_unix,pickup_lat,pickup_lon,dropoff_unix,dropoff_lat,dropoff_lon\n"
            "7,1211138400,37.72,-122.47,1211139600,37.7211,-122.42\n");
  EXPECT_EQ(table("charging.csv"),
            "cab,station,region,arrival_unix,start_unix,end_unix\n"
            "7,\"hub, \"\"north\"\"\",east,1211139600,1211140500,1211143740\n");
  EXPECT_NE(table("vacant.csv").find("\n7,1211137200,37.72,-122.47,1211138400,37.72,-122.47,0,pickup\n"),
            std::string::npos);
  EXPECT_NE(table("transitions.csv").find("10:00,west,vacant,2,occupied,east,"), std::string::npos)
      << table("transitions.csv");
  EXPECT_NE(report.find("rows: 120"), std::string::npos) << report;
  EXPECT_NE(report.find("drawn towards the day's mean: 24 of 24"), std::string::npos) << report;
}

TEST_F(IngestGps, ReadsOtherColumnsAndLocalTimes) {
  folder_.write("format.yaml", R"(columns: {vehicle: plate, time: when, lat: y, lon: x, occupied: meter}
time: local
occupied: hired
free: "-"
utc_offset_minutes: -420
clock_changes: [{utc: "2008-11-02 09:00:00", utc_offset_minutes: -480}]
)");
  // The hour from 01:00 comes twice: times that fall back belong to the second one.
  folder_.write("gps/all.csv",
                "when,plate,x,y,meter\n"
                "2008-11-02 01:50:00,a,-122.47,37.72,-\n"
                "2008-11-02 01:55:00,a,-122.47,37.72,hired\n"
                "2008-11-02 01:52:00,b,-122.47,37.72,-\n"
                "2008-11-02 01:05:00,a,-122.42,37.72,-\n"
                "2008-11-02 02:05:00,a,-122.42,37.72,-\n");
  const std::string report = ingest();
  EXPECT_NE(table("trips/trips.csv").find("a,1225616100,37.72,-122.47,1225616700,37.72,-122.42"), std::string::npos)
      << table("trips/trips.csv");
  EXPECT_EQ(report.find("dropped, out"), std::string::npos) << report;
  EXPECT_NE(report.find("vehicles: 2"), std::string::npos) << report;
}

TEST_F(IngestGps, CountsWhatItDropsByReason) {
  folder_.write("gps/cab_7.txt",
                "37.72 -122.47 0 1211137200\n"
                "37.72 -122.47 1 1211137260\n"
                "37.72 -122.47 1 1211137260\n"
                "37.72 -122.47 0 1211137200\n"
                "97.72 -122.47 0 1211137300\n"
                "37.72 -122.47 2 1211137300\n"
                "37.72 -122.47 0\n"
                "nan -122.47 0 1211137300\n"
                "\xFF\xFE\x80 -122.47 0 1211137300\n"
                "37.72 -122.47 0 99999999999999999999\n"
                "37.72 -122.42 0 1211137560\n");
  const std::string report = ingest();
  for (const std::string line :
       {"rows: 11", "no latitude in degrees, -90 to 90: 3 (first: ", "neither `1` (occupied) nor `0` (free): 1",
        "cab_7.txt:7", "no unix time in seconds: 1", "cab_7.txt:10: `99999999999999999999`",
        "out of the order of time: 1", "same time as another fix: 1", "trips: 1"}) {
    EXPECT_NE(report.find(line), std::string::npos) << line << " not in\n" << report;
  }
}

TEST_F(IngestGps, CountsWhatLiesOutsideTheRegions) {
  std::string rows;
  // An hour in the west, half an hour north, then a ride there; no car is there within two minutes.
  for (int minute = 0; minute < 120; ++minute) {
    const bool north = minute >= 60;
    rows += row(kNoon + 60 * minute, north ? 37.8 : 37.72, -122.47, minute >= 90 && minute < 119);
  }
  folder_.write("gps/cab_7.txt", rows);
  const std::string report = ingest();
  EXPECT_NE(report.find("dropped, a vehicle or the end of its ride outside the regions: 5 (first: vehicle `7` at "
                        "1211141400: `37.8, -122.47`)"),
            std::string::npos)
      << report;
}

TEST_F(IngestGps, RefusesRegionsOfAnotherPlace) {
  std::string rows;
  for (int minute = 0; minute < 120; ++minute) {
    rows += row(kNoon + 60 * minute, 40.7, -74.0, false);
  }
  folder_.write("gps/cab_7.txt", rows);
  expect_refused("no vehicle is in a region for half an hour; a region lies at 37.72, -122.47");
  expect_refused("rows: 120\n");
  expect_refused("outside the regions: 12 (first: vehicle `7` at 1211137200: `40.7, -74`)");
}

TEST_F(IngestGps, RefusesWhatIsNoSuchTable) {
  expect_refused("gps: is no folder");
  const std::string whole = packed(day_of_a_cab(), "gzip");
  folder_.write("gps/cab_7.txt.gz", whole.substr(0, whole.size() - 20));
  expect_refused("cab_7.txt.gz:");
  fs::remove_all(sources_.gps);
  folder_.write("gps/taxi_7.txt", day_of_a_cab());
  expect_refused("taxi_7.txt: is not named like `cab_*.txt`");
  fs::remove_all(sources_.gps);
  std::string swapped;
  for (int i = 0; i < 200; ++i) {
    swapped += "1211137200 37.72 -122.47 0\n";
  }
  folder_.write("gps/cab_7.txt", swapped);
  expect_refused("cab_7.txt:1: no latitude in degrees, -90 to 90: `1211137200`; none of 100 rows can be read");
  sources_.regions.clear();
  expect_refused("give --regions as well");
}

TEST_F(IngestGps, RefusesWhatIsNoFormat) {
  folder_.write("gps/cab_7.txt", day_of_a_cab());
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& reason) {
    std::string format = kFormat;
    format.replace(format.find(from), from.size(), to);
    folder_.write("format.yaml", format);
    expect_refused(reason);
  };
  refused("vehicle_in_name: \"cab_*.txt\"\n", "", "give one of them");
  refused("cab_*.txt", "cab.txt", "format.yaml:3: expected a file's name with one *");
  refused("time: unix", "time: iso", "format.yaml:5: `iso`");
  refused("free: \"0\"", "free: \"1\"", "format.yaml:7: must differ");
  refused("lat: 1", "lat: 0", "format.yaml:4");
  refused("header: false", "header: false\nheaders: 1", "unknown key `headers`");
}

TEST_F(IngestGps, KnowsNoMoreThanItIsTold) {
  folder_.write("gps/cab_7.txt", day_of_a_cab());
  folder_.write("gps/cab_8.txt", "");
  sources_.regions.clear();
  sources_.stations.clear();
  ingest();
  EXPECT_FALSE(fs::exists(folder_.path() / "out/charging.csv"));
  EXPECT_FALSE(fs::exists(folder_.path() / "out/transitions.csv"));
  EXPECT_NE(table("trips/trips.csv").find("\n7,"), std::string::npos);
}

}  // namespace
}  // namespace evbal

#include "tools/ingest/trips.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <numeric>

namespace evbal {
namespace {

/// Two squares of 0.01 degrees, `7` in the west and `9` in the east.
std::vector<Zone> two_zones() {
  std::vector<Zone> out;
  for (const auto& [name, west] : {std::pair{"7", -122.50}, std::pair{"9", -122.49}}) {
    Zone& zone = out.emplace_back();
    zone.name = name;
    add_ring(zone, {{37.74, west}, {37.74, west + 0.01}, {37.75, west + 0.01}, {37.75, west}}, false);
    measure(zone);
  }
  return out;
}

CityNotes notes_of(const std::vector<std::string>& days, LocalClock clock = LocalClock(-420)) {
  CityNotes notes;
  notes.city.days = days;
  notes.city.day_start = 5 * 60;
  notes.city.step_minutes = 30;
  notes.clock = std::move(clock);
  return notes;
}

struct Read {
  std::vector<Trip> trips;
  RowCount count;
};

Read read(const Folder& folder, const TripFormat& format, const CityNotes& notes) {
  Read out;
  out.count =
      for_each_trip(folder.path() / "trips", format, two_zones(), notes, [&](const Trip& trip) -> std::string_view {
        out.trips.push_back(trip);
        return {};
      });
  return out;
}

/// The time as clocks in UTC-7 show it.
std::string shown(long long utc) {
  using namespace std::chrono;
  const sys_seconds local{seconds(utc - 7 * 3600)};
  const year_month_day date(floor<days>(local));
  const hh_mm_ss time(local - floor<days>(local));
  const auto two = [](auto number) { return std::to_string(100 + number).substr(1); };
  return std::to_string(int(date.year())) + "-" + two(unsigned(date.month())) + "-" + two(unsigned(date.day())) + " " +
         two(time.hours().count()) + ":" + two(time.minutes().count()) + ":" + two(time.seconds().count());
}

const std::string kByZone =
    "columns: {pickup_time: tpep_pickup_datetime, dropoff_time: tpep_dropoff_datetime,\n"
    "          pickup_zone: PULocationID, dropoff_zone: DOLocationID}\n"
    "time: local\n"
    "zone_field: LocationID\n";
const std::string kByZoneHeader = "VendorID,tpep_pickup_datetime,tpep_dropoff_datetime,PULocationID,DOLocationID\n";

TEST(Trips, MayBeKnownByZone) {
  const Folder folder;
  const TripFormat format = read_trip_format(folder.write("format.yaml", kByZone));
  folder.write("trips/a.csv", kByZoneHeader +
                                  "2,2008-05-18 06:10:00,2008-05-18 06:20:00,7,9\n"
                                  "1,\"2008-05-18 23:59:00\",2008-05-19 00:09:00,9,9\n"
                                  "1,2008-05-18 12:00:00,2008-05-18 12:01:00,7,9\n"
                                  "1,2008-05-18 12:00:00,2008-05-18 12:09:00,7,264\n"
                                  "1,2008-05-18 12:00:00,2008-05-18 11:59:00,7,9\n"
                                  "1,noon,2008-05-18 11:59:00,7,9\n");
  const Read made = read(folder, format, notes_of({"2008-05-18"}));
  ASSERT_EQ(made.trips.size(), 3U);
  EXPECT_EQ(made.trips[0].step, 2);
  EXPECT_EQ(made.trips[0].minutes, 10.0);
  EXPECT_LT(made.trips[0].from.lon, -122.49);
  EXPECT_GT(made.trips[0].to.lon, -122.49);
  EXPECT_GT(made.trips[1].km, 0.0) << "places within the zone differ";
  EXPECT_EQ(made.trips[1].step, 37);
  EXPECT_EQ(made.count.dropped.rows(), 3);
  const std::string report = made.count.report();
  for (const std::string line :
       {"in a zone without polygon: `DOLocationID` is no `LocationID`, such as `7`: 1 (first: ", "a.csv:5: `264`",
        "`tpep_pickup_datetime` is no time written as 2008-05-18 07:31:05: 1 (first: ", "a.csv:7: `noon`",
        "too short in time: 1 (first: ", "a.csv:6: `2008-05-18 11:59:00`"}) {
    EXPECT_NE(report.find(line), std::string::npos) << line << " not in\n" << report;
  }
  EXPECT_EQ(read(folder, format, notes_of({"2008-05-18"})).trips[0].from.lat, made.trips[0].from.lat);
}

TEST(Trips, FollowTheClocks) {
  const Folder folder;
  const TripFormat format = read_trip_format(folder.write("format.yaml", kByZone));
  // California goes over to winter time on 2 November at 02:00, and to summer time on 9 March.
  const LocalClock california(-480, {{1205056800, -420}, {1225616400, -480}});
  CityNotes notes = notes_of({"2008-03-09", "2008-11-02"}, california);
  notes.city.day_start = 0;
  folder.write("trips/a.csv", kByZoneHeader +
                                  "1,2008-11-02 01:50:00,2008-11-02 01:10:00,7,9\n"
                                  "1,2008-03-09 01:50:00,2008-03-09 03:10:00,7,9\n"
                                  "1,2008-03-09 02:10:00,2008-03-09 03:10:00,7,9\n");
  const Read made = read(folder, format, notes);
  ASSERT_EQ(made.trips.size(), 2U);
  EXPECT_EQ(made.trips[0].minutes, 20.0) << "the hour comes twice";
  EXPECT_EQ(made.trips[1].minutes, 20.0) << "the hour is left out";
  EXPECT_EQ(made.count.dropped.rows("at a local time that the clocks skipped"), 1);
}

void expect_refused(const std::string& format, const std::string& table, const std::string& reason) {
  const Folder folder;
  folder.write("trips/a.csv", table);
  try {
    read(folder, read_trip_format(folder.write("format.yaml", format)), notes_of({"2008-05-18"}));
    FAIL() << "was accepted, expected: " << reason;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
  }
}

TEST(Trips, AreRefusedIfTheDescriptionIsOfAnotherTable) {
  expect_refused(kByZone, "VendorID,tpep_pickup_datetim\n",
                 "a.csv:1: has no column `tpep_pickup_datetime` (did you mean");
  std::string rows;
  for (int i = 0; i < 100; ++i) {
    rows += "1,18.05.2008 06:10,18.05.2008 06:20,7,9\n";
  }
  expect_refused(kByZone, kByZoneHeader + rows,
                 "a.csv:2: `tpep_pickup_datetime` is no time written as 2008-05-18 07:31:05: `18.05.2008 06:10`; none "
                 "of 100 rows");
  expect_refused(kByZone + "zone: x\n", kByZoneHeader, "format.yaml:5: unknown key `zone`");
  expect_refused("columns: {pickup_time: a}\ntime: unix\n", "a\n", "format.yaml:1: key `pickup_lat` is missing");
  expect_refused("zone_field: \"\"\n" + kByZone, "a\n", "format.yaml");
}

RC_GTEST_PROP(TripsProperty, AreTheSameInAnyLayout, (std::vector<std::uint16_t> draws)) {
  const Folder own;
  const Folder other;
  const std::string separator = *rc::gen::element<std::string>("comma", "semicolon", "tab", "space");
  const std::string between = separator == "comma"       ? ","
                              : separator == "semicolon" ? ";"
                              : separator == "tab"       ? "\t"
                                                         : " ";
  std::vector<int> order{0, 1, 2, 3, 4, 5};
  std::rotate(order.begin(), order.begin() + *rc::gen::inRange(0, 6), order.end());
  std::string own_rows = "pickup_unix,pickup_lat,pickup_lon,dropoff_unix,dropoff_lat,dropoff_lon\n";
  std::string other_rows;
  for (const int draw : draws) {
    const long long pickup = 1211094000 + 3LL * draw;  // 2008-05-18 00:00 in UTC-7, and two days on
    const std::string lat = std::to_string(37.74 + 1e-6 * draw);
    const std::vector<std::string> fields{shown(pickup), lat, "-122.5", shown(pickup + draw % 900), "37.75", "-122.49"};
    own_rows +=
        std::to_string(pickup) + "," + lat + ",-122.5," + std::to_string(pickup + draw % 900) + ",37.75,-122.49\n";
    for (const int field : order) {
      std::string text = fields[static_cast<std::size_t>(field)];
      std::replace(text.begin(), text.end(), ' ', 'T');
      other_rows += text + (field == order.back() ? "\n" : between);
    }
  }
  const auto column = [&](int field) {
    return std::to_string(1 + (std::find(order.begin(), order.end(), field) - order.begin()));
  };
  own.write("trips/a.csv", own_rows);
  other.write("trips/a.txt", other_rows);
  const TripFormat format = read_trip_format(other.write(
      "format.yaml", "separator: " + separator + "\nheader: false\ntime: local\ncolumns: {pickup_time: " + column(0) +
                         ", pickup_lat: " + column(1) + ", pickup_lon: " + column(2) + ", dropoff_time: " + column(3) +
                         ", dropoff_lat: " + column(4) + ", dropoff_lon: " + column(5) + "}\n"));
  const Read a = read(own, own_trip_format(), notes_of({"2008-05-18", "2008-05-19"}));
  const Read b = read(other, format, notes_of({"2008-05-18", "2008-05-19"}));
  for (const std::string reason : {"before the day's start", "too short in time", "too fast", "on another day"}) {
    RC_ASSERT(a.count.dropped.rows(reason) == b.count.dropped.rows(reason));
  }
  RC_ASSERT(a.trips.size() == b.trips.size());
  RC_ASSERT(a.trips.size() + static_cast<std::size_t>(a.count.dropped.rows()) == draws.size());
  for (std::size_t i = 0; i < a.trips.size(); ++i) {
    RC_ASSERT(a.trips[i].day == b.trips[i].day && a.trips[i].step == b.trips[i].step);
    RC_ASSERT(a.trips[i].minutes == b.trips[i].minutes && a.trips[i].from.lat == b.trips[i].from.lat);
  }
}

}  // namespace
}  // namespace evbal

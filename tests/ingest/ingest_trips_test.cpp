#include "tools/ingest/ingest_trips.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace evbal {
namespace {

const std::string kTripsNotes = R"(name: small
source: nobody
utc_offset_minutes: -420
day_start: "05:00"
step: 30min
days: {train: [2008-05-18], test: [2008-05-19], holidays: [2008-05-19]}
trips: {shortest: 1min, longest: 120min, fastest_kmh: 120, detour: 1.3}
zones:
  reach_km: 11
  snap_m: 500
  apart: [{name: airport, lat: 37.7450, lon: -122.4950}]
fleet: {vehicles: 10, battery_kwh: 40, km_per_kwh: 5.5, initial_charge: [0.3, 0.9]}
charging: {power_kw: 50, stations: 2, points: 3, session_model: Rapid, shortest_session: 12min, longest_session: 90min}
passengers: {patience: [8min, 20min]}
)";

/// A grid of 6 x 6 zones of 0.01 degrees (about 1 km) from (37.74, -122.50) on.
std::string zones_geojson() {
  std::string out = R"({"type": "FeatureCollection", "features": [)";
  const auto corner = [](int x, int y) {
    return "[" + std::to_string(-122.50 + 0.01 * x) + "," + std::to_string(37.74 + 0.01 * y) + "]";
  };
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) {
      out += std::string(x + y > 0 ? "," : "") +
             R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[)" + corner(x, y) + "," +
             corner(x + 1, y) + "," + corner(x + 1, y + 1) + "," + corner(x, y + 1) + "," + corner(x, y) + "]]}}";
    }
  }
  return out + "]}";
}

constexpr long long kMidnight = 1211094000;  // 2008-05-18 00:00 in UTC-7

std::string row(long long pickup, double lat, double lon, long long dropoff, double to_lat, double to_lon) {
  return "cab," + std::to_string(pickup) + "," + std::to_string(lat) + "," + std::to_string(lon) + "," +
         std::to_string(dropoff) + "," + std::to_string(to_lat) + "," + std::to_string(to_lon) + "\n";
}

/// Trips between all parts of the grid on both days, and one row for every reason to drop one.
std::string trips_csv() {
  std::string out = "cab,pickup_unix,pickup_lat,pickup_lon,dropoff_unix,dropoff_lat,dropoff_lon\n";
  for (int k = 0; k < 360; ++k) {
    const long long pickup = kMidnight + (k % 2) * 86'400 + 6 * 3600 + 60 * k;
    out += row(pickup, 37.745 + 0.01 * (k % 6), -122.495 + 0.01 * (k / 6 % 6), pickup + 600,
               37.745 + 0.01 * (k / 36 % 6), -122.495 + 0.01 * (k / 5 % 6));
  }
  const long long noon = kMidnight + 12 * 3600;
  out += row(noon, 37.76, -122.47, noon + 30, 37.76, -122.47);                             // too short
  out += row(noon, 37.76, -122.47, noon + 9000, 37.76, -122.48);                           // too long
  out += row(noon, 37.76, -122.47, noon + 61, 37.79, -122.44);                             // too fast
  out += row(kMidnight + 3 * 3600, 37.76, -122.47, kMidnight + 11'400, 37.76, -122.48);    // before the day
  out += row(noon + 3 * 86'400, 37.76, -122.47, noon + 3 * 86'400 + 600, 37.76, -122.48);  // another day
  out += row(noon, 37.76, -122.47, noon + 1800, 37.95, -122.47);                           // outside
  out += row(noon, 37.7598, -122.5005, noon + 600, 37.76, -122.48);                        // 40 m outside: moved
  out += "cab,x,37.7,-122.4,1,37.7,-122.4\n";
  return out;
}

class IngestTrips : public testing::Test {
 protected:
  IngestTrips() {
    folder_.write("trips/a.csv", trips_csv());
    folder_.write("sessions/a.csv",
                  "Start Date,Start Time,End Date,End Time,Model\n01/12/2017,12:00,01/12/2017,12:20,Rapid\n");
    sources_ = {folder_.path() / "trips",
                {},
                folder_.write("zones.geojson", zones_geojson()),
                folder_.path() / "sessions",
                folder_.write("notes.yaml", kTripsNotes),
                6};
  }

  void expect_refused(const std::string& reason) {
    try {
      ingest_trips(sources_);
      FAIL() << "was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  Folder folder_;
  TripSources sources_;
};

int trips_of(const DemandDay& day) {
  int trips = 0;
  for (const auto& step : day.steps) {
    trips += std::accumulate(step.begin(), step.end(), 0, [](int sum, const TripCount& c) { return sum + c.trips; });
  }
  return trips;
}

TEST_F(IngestTrips, MakesACityThatReadsBack) {
  const IngestedCity made = ingest_trips(sources_);
  EXPECT_EQ(made.city.size(), 6);
  EXPECT_EQ(made.city.regions.back().name, "airport");
  EXPECT_EQ(made.city.points().sum(), 3);
  ASSERT_EQ(made.days.size(), 2U);
  EXPECT_EQ(trips_of(made.days[0]) + trips_of(made.days[1]), 361);
  EXPECT_FALSE(made.days[0].holiday);
  EXPECT_TRUE(made.days[1].holiday);
  EXPECT_GT(made.city.km.minCoeff(), 0.0);
  write_city(made.city, made.days, folder_.path() / "pack");
  const City city = read_city(folder_.path() / "pack");
  EXPECT_EQ(city.km, made.city.km);
  EXPECT_EQ(trips_of(read_demand(city, "2008-05-19")), trips_of(made.days[1]));
}

TEST_F(IngestTrips, SaysWhatItDropped) {
  const std::string report = ingest_trips(sources_).report;
  for (const std::string line :
       {"rows read: 368", "too short in time: 1", "too long in time: 1", "too fast: 1", "before the day's start: 1",
        "on another day: 1", "`pickup_unix` is no number of seconds since 1970, such as 1211095865: 1",
        "outside the regions: 1", "nearest zone: 1", "trips used: 361"}) {
    EXPECT_NE(report.find(line), std::string::npos) << line << " not in\n" << report;
  }
}

TEST_F(IngestTrips, CountsEveryTripInItsStep) {
  const IngestedCity made = ingest_trips(sources_);
  // Day 1 has a trip every two minutes from 06:00 on: 15 in each step from the third one on.
  const auto& steps = made.days[0].steps;
  const auto trips = [&](int step) {
    return std::accumulate(steps[step].begin(), steps[step].end(), 0,
                           [](int sum, const TripCount& c) { return sum + c.trips; });
  };
  EXPECT_EQ(trips(1), 0);
  EXPECT_EQ(trips(2), 15);
  EXPECT_EQ(trips(13), 15);
  EXPECT_EQ(trips(14), 1) << "the one that was moved";
}

TEST_F(IngestTrips, RefusesWhatIsNoInput) {
  folder_.write("trips/b.csv", "cab,when\n");
  expect_refused("b.csv:1: has no column `pickup_unix`");
  folder_.write("trips/b.csv", text_of(folder_.path() / "trips/a.csv"));
  folder_.write("zones.geojson", zones_geojson().substr(0, 500));
  expect_refused("zones.geojson:1: is no GeoJSON: it breaks off");
  folder_.write("zones.geojson", zones_geojson());
  sources_.regions = 60;
  expect_refused("cannot make 60 regions");
  expect_refused("on another day: 2 (first: ");
  folder_.write("notes.yaml", std::string(kTripsNotes).replace(kTripsNotes.find("reach_km: 11"), 12, "reach_km: 2 "));
  expect_refused("dropped, zones out of reach: ");
  folder_.write("notes.yaml", kTripsNotes);
  sources_.regions = 6;
  folder_.write("notes.yaml", kTripsNotes + "more: 1\n");
  expect_refused("notes.yaml:15: unknown key `more`");
}

}  // namespace
}  // namespace evbal

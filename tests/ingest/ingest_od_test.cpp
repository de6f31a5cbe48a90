#include "tools/ingest/ingest_od.hpp"

#include "agents/world/synthetic.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tools/ingest/course.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// Four squares of 0.01 degrees in a row.
std::string zones() {
  std::string out = R"({"type": "FeatureCollection", "features": [)";
  for (int i = 0; i < 4; ++i) {
    const std::string west = std::to_string(114.0 + 0.01 * i);
    const std::string east = std::to_string(114.01 + 0.01 * i);
    out += std::string(i > 0 ? "," : "") +
           R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[)" + west + ",22.5],[" +
           east + ",22.5],[" + east + ",22.51],[" + west + ",22.51],[" + west + ",22.5]]]}}";
  }
  return out + "]}";
}

const std::string kOdNotes = R"(name: small
source: nobody
trips:
  columns: {from_lat: r1, from_lon: c1, to_lat: r2, to_lon: c2, trips: n}
  grid: {lat: 22.505, lon: 114.005, lat_step: 0.005, lon_step: 0.01}
seed: 3
share: 0.5
within_day: 0.8
travel: {detour: 1.4, start: 5min, minutes_per_km: 2}
snap_m: 500
fleet: {vehicles: 10, battery_kwh: 40, km_per_kwh: 5.5, initial_charge: [0.3, 0.9]}
stations: {columns: {name: id, lat: lat, lon: lon, points: fast}, share: 0.5, power_kw: 50}
passengers: {patience: [8min, 20min]}
)";

class IngestOd : public testing::Test {
 protected:
  IngestOd() {
    const SyntheticCity like = synthetic_city({});
    write_city(like.city, like.days, folder_.path() / "like");
    sources_ = {
        folder_.write("trips.csv",
                      "r1,c1,r2,c2,n\n"
                      "0,0,0,1,30\n"
                      "0,1,0,0,10\n"
                      "0,2,0,3,20\n"
                      "0,3,0,0,20\n"
                      "0,0,0,9,7\n"     // far outside
                      "0,0,0,-1,x\n"),  // no number
        folder_.write("zones.geojson", zones()),
        folder_.write("stations.csv", "id,lat,lon,fast\na,22.505,114.005,5\nb,22.505,114.035,4\nc,22.505,114.036,0\n"),
        folder_.write("notes.yaml", kOdNotes),
        folder_.path() / "like",
        4};
  }

  Folder folder_;
  OdSources sources_;
};

TEST_F(IngestOd, MakesACityOfFactors) {
  const OdCity made = ingest_od(sources_);
  const City& city = made.city;
  EXPECT_EQ(city.name, "small-4");
  ASSERT_EQ(city.size(), 4);
  EXPECT_EQ(city.days.size(), 12U);
  const CityFactors& factors = *city.factors;
  int trips = 0;
  for (const TripCount& pair : factors.pairs) {
    trips += pair.trips;
  }
  EXPECT_EQ(factors.pairs.size(), 4U);
  EXPECT_EQ(trips, 80);
  EXPECT_NEAR(factors.course.sum(), 0.8 * 12, 1e-3) << "days average to the share within the day";
  EXPECT_EQ(city.points().sum(), 5) << "half of nine, rounded, by largest remainders";
  for (const std::string line :
       {"trip rows read: 6", ": 1 (first: ", "an end outside the zones: 7 (first: ", "trips used: 80"}) {
    EXPECT_NE(made.report.find(line), std::string::npos) << line << " not in\n" << made.report;
  }
  write_city(city, {}, folder_.path() / "pack");
  EXPECT_EQ(read_city(folder_.path() / "pack").km, city.km);
}

TEST_F(IngestOd, BalancesPickUps) {
  sources_.regions = 2;
  const OdCity made = ingest_od(sources_);
  double first = 0.0;
  for (const TripCount& pair : made.city.factors->pairs) {
    first += pair.origin == 0 ? pair.trips : 0.0;
  }
  EXPECT_EQ(first, 40.0);
}

TEST_F(IngestOd, SaysWhatItDropsAndTakesFloats) {
  folder_.write(
      "trips.csv",
      "r1,c1,r2,c2,n\n0,0,0,1,30.0\n0.0,1.0,0,2,20\n0,2,0,3,\n0,2,0,3,2.5\n0,z,0,3,1\n0,0,90000,0,1\n0,3,\"0,0,1\n"
      "0,3,0,0,20\n0,0,0,9,7\n");
  const std::string report = ingest_od(sources_).report;
  for (const std::string line :
       {"trip rows read: 9", "`n` is no number of trips, 1 to 1000000: 2 (first: ", "trips.csv:4: ``)",
        "`c1` is no number: 1 (first: ", "trips.csv:6: `z`)",
        "a cell that is not on the earth: 1 (first: ", "trips.csv:7: `90000`)", "quotes that do not pair: 1 (first: ",
        "trips.csv:8: ", "an end outside the zones: 7 (first: 22.505, 114.095)", "trips used: 70"}) {
    EXPECT_NE(report.find(line), std::string::npos) << line << " not in\n" << report;
  }
  folder_.write("trips.csv", "r1,c1,r2,c2,n\nx,0,0,1,30\n");
  try {
    ingest_od(sources_);
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("trips.csv:2: `r1` is no number: `x`; none of 1 rows can be read"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(IngestOd, RefusesWhatIsNoInput) {
  folder_.write("trips.csv", "r1,c1,r2,c2,n\n0,0,0,9,7\n");
  try {
    ingest_od(sources_);
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("has no trip between two zones; a zone lies at 22.505, "),
              std::string::npos)
        << error.what();
  }
  folder_.write("trips.csv", "r1,c1,r2,c2,count\n0,0,0,1,7\n");
  EXPECT_THROW(ingest_od(sources_), Error);
}

TEST(CourseOf, MeasuresDaysAndRegions) {
  // Workdays of 600 trips in the first step and 1200 in the second; regions differ by 10 % from day to day.
  std::vector<DemandDay> days;
  for (int day = 0; day < 20; ++day) {
    const int more = day % 2 == 0 ? 30'000 : -30'000;
    const int date = day / 5 * 7 + day % 5 + 1;  // from Monday 2024-01-01 on
    days.push_back({(date < 10 ? "2024-01-0" : "2024-01-") + std::to_string(date), false, {}});
    days.back().steps = {{{0, 0, 300'000 + more}, {1, 0, 300'000 - more}},
                         {{0, 0, 600'000 + 2 * more}, {1, 0, 600'000 - 2 * more}}};
  }
  const Course course = course_of(days, 2);
  EXPECT_NEAR(course.share(3, 0), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(course.share(3, 1), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(course.region_deviation, 0.1, 1e-4);
}

}  // namespace
}  // namespace evbal

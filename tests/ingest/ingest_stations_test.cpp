#include "tools/ingest/ingest_stations.hpp"

#include "agents/world/geometry.hpp"
#include "agents/world/regions_file.hpp"
#include "agents/world/stations_yaml.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// Two squares of 0.01 degrees, west and east.
std::vector<Region> station_regions() {
  const auto square = [](double west) {
    return Outline{{{22.5, west}, {22.5, west + 0.01}, {22.51, west + 0.01}, {22.51, west}}};
  };
  return {{"west", square(114.0), {22.505, 114.005}}, {"east", square(114.01), {22.505, 114.015}}};
}

class IngestStations : public testing::Test {
 protected:
  IngestedStations ingest(const std::string& rows) {
    folder_.write("stations.csv", "id,longitude,latitude,plugs\n" + rows);
    YamlMap map(YamlValue::parse(format_, "format.yaml"));
    return ingest_stations(folder_.path() / "stations.csv", read_station_format(map), station_regions(), 500.0);
  }

  Folder folder_;
  std::string format_ = "columns: {name: id, lat: latitude, lon: longitude, points: plugs}\n";
};

TEST_F(IngestStations, LieInTheirRegionOrTheNearest) {
  const auto made = ingest(
      "b,114.015,22.505,3\n"
      "a,114.005,22.505,2\n"
      "\"c, by the sea\",114.021,22.505,1\n"
      "far,114.05,22.505,1\n"
      "shut,114.005,22.505,0\n"
      "b,114.015,22.505,3\n"
      "torn,114.015\n"
      "\xFF\xFE,114.015,22.505,3\n"
      "north,114.015,122.505,3\n");
  ASSERT_EQ(made.stations.size(), 3U);
  EXPECT_EQ(made.stations[0].name, "a");
  EXPECT_EQ(made.stations[0].region, 0);
  EXPECT_EQ(made.stations[1].name, "b");
  EXPECT_EQ(made.stations[1].points, 6);
  EXPECT_EQ(made.stations[2].name, "c, by the sea");
  EXPECT_EQ(made.stations[2].region, 1);
  for (const std::string line :
       {"rows read: 9", "no latitude in degrees, -90 to 90: 1 (first: ", "name is not UTF-8: 1", "no points: 1",
        "outside the regions: 1", "points added up: 1", "3 with 9 points in 2 of 2 regions", "nearest: 1"}) {
    EXPECT_NE(made.report.find(line), std::string::npos) << line << " not in\n" << made.report;
  }
}

TEST_F(IngestStations, AreWrittenAsAPackHoldsThem) {
  const auto made = ingest("a,114.005,22.505,2\nb,114.015,22.505,3\n");
  const auto file = folder_.write("stations.yaml", stations_yaml(made.stations, station_regions()));
  const auto read = read_stations(file, station_regions());
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].name, "b");
  EXPECT_EQ(read[1].region, 1);
  EXPECT_EQ(read[1].place.lon, 114.015);
  const auto regions_file = folder_.write("regions.geojson", regions_geojson(station_regions()));
  EXPECT_EQ(read_regions(regions_file)[1].outline[0].size(), 4U);
}

TEST_F(IngestStations, AreRefusedWithoutTheirColumns) {
  format_ = "columns: {name: id, lat: latitude, lon: longitude, points: plug}\n";
  try {
    ingest("a,114.005,22.505,2\n");
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("stations.csv:1: has no column `plug` (did you mean `plugs`?)"),
              std::string::npos)
        << error.what();
  }
  format_ = "columns: {name: id, lat: latitude, lon: longitude, points: plugs}\n";
  try {
    ingest("far,114.05,22.505,1\n");
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what())
                  .find("has no station in a region; one lies at 22.505, 114.05, a region at 22.505, 114.005\n"
                        "  dropped, outside the regions: 1 (first: "),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace evbal
